// SPDX-License-Identifier: Apache-2.0
#pragma once
// Textures of colors (Texture::color_map), which glTF does not have.
#include <optional>

#include "export/gltf/losses.h"
#include "glint/scene.h"

namespace glint::gltf_export {

/// The scene with the mean color of each such texture in its materials. Nothing if it has none.
std::optional<Scene> with_mean_colors(const Scene& scene, Losses& losses);

}  // namespace glint::gltf_export
