// SPDX-License-Identifier: Apache-2.0
#pragma once
// The shapes of a scene as .glint writes them, in their order.
#include "formats/block_writer.h"
#include "formats/comments.h"
#include "formats/write_materials.h"

namespace glint {

/// Shapes that follow each other and have the same transform make a group.
void write_shapes(BlockWriter& block, const Scene& scene, const MaterialPlan& materials,
                  const SceneComments& comments);

}  // namespace glint
