// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures as the bytes of a file; causes are judged by these.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "base/parallel_for.h"
#include "glint/compare.h"
#include "glint/image.h"
#include "image/stored_picture.h"

namespace glint {

struct BytePicture {
    std::int32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< like Image::rgb

    const std::uint8_t* pixel(std::int32_t x, std::int32_t y) const {
        return &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
    }
    std::uint8_t* pixel(std::int32_t x, std::int32_t y) {
        return &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
    }
};

/// Numbers that are converted at a time, in a buffer on the stack.
inline constexpr std::size_t k_values_at_a_time = 1024;

/// The bytes that encode() writes. Throws bad_alloc.
BytePicture to_bytes(const PictureView& picture, int threads, const ByteRule& rule = {});

/// The bytes as channels n / 255.
inline PictureView view_of(const BytePicture& picture) {
    return {picture.width, picture.height, picture.rgb};
}

/// Whether a channel of two pixels differs by more than k_edge_step.
inline bool is_step(const std::uint8_t* a, const std::uint8_t* b) {
    int most = 0;
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
    return most > static_cast<int>(k_edge_step);
}

/// One number per pixel: whether it is on an edge (k_edge_step of glint/compare.h). Throws bad_alloc.
std::vector<std::uint8_t> edges_of(const BytePicture& picture, int threads);

/// The rows of a picture to process, from the top down.
using Rows = std::vector<std::int32_t>;
Rows all_rows(std::int32_t height);
/// If there are more than `k_sample` pixels, one row of each group of rows, at varying positions in the group
/// so that no pattern of rows is missed. Else all rows.
inline constexpr std::size_t k_sample = std::size_t{1} << 20;
Rows sample_of(const Rows& rows, std::int32_t width);

/// Calls body(y) for every row, on several threads. body must not throw.
template <class Body> void for_each_row(const Rows& rows, int threads, Body&& body) {
    parallel_for(rows.size(), threads, [&](std::size_t i) { body(rows[i]); });
}

/// The options for comparing two pictures.
struct Area {
    const std::vector<std::uint8_t>* edges = nullptr;  ///< of the reference, one per pixel
    Rows rows;
    std::int32_t rim = 1;  ///< outermost pixels to ignore: unknown in a shifted picture
    int threads = 0;
};

/// Mean differences between two pictures' channels, in 255ths. Means of absolute values, so that a few
/// large differences do not dominate.
struct Distance {
    double all = 0;
    double calm = 0;  ///< only away from edges and above k_noise, to ignore samples and rounding
};
inline constexpr int k_noise = 2, k_rounding = 1;  ///< rounding changes a byte by k_rounding
Distance distance(const BytePicture& a, const BytePicture& b, const Area& area);

/// How much the channels differ by more than rounding, in all.
std::size_t beyond_rounding(const BytePicture& a, const BytePicture& b);

/// Whether these rows are equal.
bool equal_rows(const BytePicture& a, const BytePicture& b, const Rows& rows);

}  // namespace glint
