#pragma once
// Pictures as the numbers that are compared.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glint/image.h"

namespace glint {

/// Channels, 3 a pixel, row by row from the top: bytes (unit 1), or the floats as they are (unit 255).
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
