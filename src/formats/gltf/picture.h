// SPDX-License-Identifier: Apache-2.0
#pragma once
// The pixels of a texture, from the bytes of a PNG or JPEG.
#include <memory>
#include <string_view>

#include "formats/gltf/textures.h"

namespace glint::gltf {

/// Null, with a warning at `image`, if the bytes are no picture that glint reads.
std::shared_ptr<const TextureImage> read_texture_image(File& file, JsonValue image, std::string_view bytes,
                                                       const TextureAlpha& alpha);

/// What the material's alphaMode does to the picture.
void apply_alpha(TextureImage& image, const TextureAlpha& alpha);

}  // namespace glint::gltf
