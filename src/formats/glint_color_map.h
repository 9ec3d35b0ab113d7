// SPDX-License-Identifier: Apache-2.0
#pragma once
// `color_map` of textures and of the background gradient.
#include <vector>

#include "formats/glint_text.h"

namespace glint {

/// Reads ((place, color), (place, color, alpha), ...) after the key `at`. False after an error. has_alpha:
/// whether colors may have one.
bool read_color_map(GlintText& t, const Token& at, bool has_alpha, std::vector<TextureColor>& colors);

}  // namespace glint
