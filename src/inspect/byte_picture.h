#pragma once
// Pictures as the bytes that a file would hold: what causes are judged by.
#include <cstdint>
#include <vector>

#include "glint/image.h"

namespace glint {

struct BytePicture {
    std::int32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< as Image::rgb

    const std::uint8_t* pixel(std::int32_t x, std::int32_t y) const {
        return &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
    }
    std::uint8_t* pixel(std::int32_t x, std::int32_t y) {
        return &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
    }
};

/// The bytes that encode() writes. Throws bad_alloc.
BytePicture to_bytes(const Image& image, int threads, Transfer transfer = Transfer::none);

/// The mean of all channels' differences, in 255ths, of two pictures of one size. A mean of absolute values:
/// few large differences, as edges have, weigh no more than they are.
double mean_difference(const BytePicture& a, const BytePicture& b);

}  // namespace glint
