// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures in the form in which they are compared.
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

/// Channels, 3 per pixel, row by row from the top: bytes (unit 1), or unchanged floats (unit 255); 0
/// for values that are not finite.
struct Levels {
    std::vector<float> values;
    double unit = 1;  ///< 255ths per unit of the values
    std::int32_t width = 0, height = 0;
};
Levels levels_of(const Image& image, bool as_floats, int threads);

/// The reason why two pictures cannot be compared, or an empty string.
std::string pair_fault(const Image& a, const Image& b);

/// One number per pixel: whether it is on an edge (k_edge_step).
std::vector<std::uint8_t> find_edges(const Levels& levels, int threads);

/// PictureDifference::ssim for the levels of two pictures.
std::optional<double> ssim(const Levels& a, const Levels& b, int threads);

}  // namespace glint
