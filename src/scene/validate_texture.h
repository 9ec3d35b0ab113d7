// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "glint/texture.h"

namespace glint {

/// What is wrong with a map of colors, as "color_map: expected ..., found ..."; empty: nothing.
std::string mistake_in(const std::vector<TextureColor>& colors);
/// What is wrong with the image of a texture, as "expected ..., found ..."; empty: nothing.
std::string mistake_in(const Texture& texture);

}  // namespace glint
