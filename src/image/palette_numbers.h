// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers that texels have in a palette, for what they mean other than colors.
#include <string>
#include <string_view>

namespace glint {

/// A PNG file with a palette as the same one with other colors: red is the color's number, the others are 0.
/// Empty if it is none, or is cut off before the palette's end.
std::string png_of_palette_numbers(std::string_view file);

}  // namespace glint
