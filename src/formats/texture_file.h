// SPDX-License-Identifier: Apache-2.0
#pragma once
// The pictures that textures show.
#include <memory>
#include <string>

#include "formats/load_state.h"
#include "glint/texture.h"

namespace glint {

/// The ends of names of files that are opened as pictures, in lower case.
inline constexpr std::string_view k_picture_extensions[] = {".png", ".jpg", ".jpeg", ".tga", ".ppm", ".pgm"};

/// The image of the file `name`, relative to the text `from`; a file is decoded once, and only if its
/// name ends as a picture's. path: its name in
/// Scene::files. Null after an error, which is reported at `at`. without: if the scene can do without the
/// picture, the end of the warning that then stands for an error.
std::shared_ptr<const TextureImage> texture_image_of_file(LoadState& reading, const ReadText& from,
                                                          const Token& at, const std::string& name,
                                                          std::string& path, std::string_view without = {});

/// Decodes the bytes of a PNG, JPEG, TGA or PPM file. Null, and `why`, if they are none or too large.
std::shared_ptr<const TextureImage> decode_texture_image(LoadState& reading, std::string_view bytes,
                                                         std::string& why);

}  // namespace glint
