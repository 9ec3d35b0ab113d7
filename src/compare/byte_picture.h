// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures as the bytes that a file would hold: what causes are judged by.
#include <cstdint>
#include <vector>

#include "base/parallel_for.h"
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

/// Rows of a picture that something is done with, from the top down.
using Rows = std::vector<std::int32_t>;
Rows all_rows(std::int32_t height);
/// Of rows with more than `k_sample` pixels one of every few, each at another place among its few: no pattern
/// of rows is missed. Else all of them.
inline constexpr std::size_t k_sample = std::size_t{1} << 20;
Rows sample_of(const Rows& rows, std::int32_t width);

/// Calls body(y) for every row, on several threads. body must not throw.
template <class Body> void for_each_row(const Rows& rows, int threads, Body&& body) {
    parallel_for(rows.size(), threads, [&](std::size_t i) { body(rows[i]); });
}

/// Where two pictures are held against each other.
struct Area {
    const std::vector<std::uint8_t>* edges = nullptr;  ///< of the reference, one a pixel
    Rows rows;
    std::int32_t rim =
        1;  ///< outermost pixels that are left out: what a shifted picture has there nobody knows
    int threads = 0;
};

/// Mean differences of two pictures' channels, in 255ths. They are means of absolute values, so that few
/// large differences weigh no more than they are.
struct Distance {
    double all = 0;
    double calm =
        0;  ///< away from edges, and only what exceeds k_noise: the same whatever samples and roundings
};
inline constexpr int k_noise = 2;
Distance distance(const BytePicture& a, const BytePicture& b, const Area& area);

/// Are these rows the same?
bool equal_rows(const BytePicture& a, const BytePicture& b, const Rows& rows);

}  // namespace glint
