// SPDX-License-Identifier: Apache-2.0
#pragma once
// Writes the shapes of a scene to .glint, in their order.
#include "formats/block_writer.h"
#include "formats/comments.h"
#include "formats/write_materials.h"

namespace glint {

/// Consecutive shapes with the same transform form a group.
void write_shapes(BlockWriter& block, const Scene& scene, const MaterialPlan& materials,
                  const SceneComments& comments);

}  // namespace glint
