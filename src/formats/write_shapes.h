// SPDX-License-Identifier: Apache-2.0
#pragma once
// Writes the shapes of a scene to .glint, in their order.
#include <span>
#include <string>

#include "formats/block_writer.h"
#include "formats/comments.h"
#include "formats/write_materials.h"

namespace glint {

/// Consecutive shapes with the same transform form a group. mesh_files: as write_glint() has them.
void write_shapes(BlockWriter& block, const Scene& scene, const MaterialPlan& materials,
                  const SceneComments& comments, std::span<const std::string> mesh_files);

}  // namespace glint
