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

/// One number a pixel: does it lie on an edge (k_edge_step of glint/compare.h)? Throws bad_alloc.
std::vector<std::uint8_t> edges_of(const BytePicture& picture, int threads);

/// Mean differences of two pictures' channels, in 255ths. They are means of absolute values, so that few
/// large differences weigh no more than they are. The outermost pixels are left out: what a shifted picture
/// has there nobody knows.
struct Distance {
    double all = 0;
    double calm =
        0;  ///< away from edges, and only what exceeds k_noise: the same whatever samples and roundings
};
inline constexpr int k_noise = 2;
Distance distance(const BytePicture& a, const BytePicture& b, const std::vector<std::uint8_t>& edges);

}  // namespace glint
