// SPDX-License-Identifier: Apache-2.0
#pragma once
// Textures and maps of colors in .glint.
#include "formats/block_writer.h"
#include "formats/comments.h"
#include "formats/write_materials.h"

namespace glint {

/// `color_map`, if there are colors.
void write_color_map(BlockWriter& block, const std::vector<TextureColor>& colors);

/// The `texture` blocks of a scene, under the names that the plan's materials use. An image without a file is
/// written as texels.
void write_textures(BlockWriter& block, const Scene& scene, const MaterialPlan& plan,
                    const SceneComments& comments);

}  // namespace glint
