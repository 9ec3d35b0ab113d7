// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures as the numbers that are compared.
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glint/image.h"

namespace glint {

/// Neither infinite nor NaN: not all bits of the exponent are set.
inline bool is_finite(float value) {
    return (std::bit_cast<std::uint32_t>(value) & 0x7f800000u) != 0x7f800000u;
}
inline bool is_finite_pixel(const float* rgb) {
    return is_finite(rgb[0]) && is_finite(rgb[1]) && is_finite(rgb[2]);
}

/// Channels, 3 a pixel, row by row from the top: bytes (unit 1), or the floats as they are (unit 255), and 0
/// for what is not finite.
struct Levels {
    std::vector<float> values;
    double unit = 1;  ///< 255ths that a value of 1 stands for
    std::int32_t width = 0, height = 0;
};
Levels levels_of(const Image& image, bool as_floats, int threads);

/// Why two pictures cannot be held against each other, or an empty string.
std::string pair_fault(const Image& a, const Image& b);

/// One number a pixel: does it lie on an edge (k_edge_step)?
std::vector<std::uint8_t> find_edges(const Levels& levels, int threads);

/// PictureDifference::ssim of two pictures' levels.
std::optional<double> ssim(const Levels& a, const Levels& b, int threads);

}  // namespace glint
