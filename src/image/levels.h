// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures in the form in which they are compared, row by row.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>

#include "glint/compare.h"
#include "image/stored_picture.h"

namespace glint {

/// Neither infinite nor NaN: not all bits of the exponent are set.
inline bool is_finite(float value) {
    return (std::bit_cast<std::uint32_t>(value) & 0x7f800000u) != 0x7f800000u;
}
inline bool is_finite_pixel(const float* rgb) {
    return is_finite(rgb[0]) && is_finite(rgb[1]) && is_finite(rgb[2]);
}

/// The reason why two pictures cannot be compared, or an empty string.
std::string pair_fault(const PictureView& a, const PictureView& b);

/// compare() of glint/compare.h, of pictures that may be stored otherwise.
Result<PictureDifference> compare(const PictureView& a, const PictureView& b, const CompareOptions& options);

/// The rows of difference_image().
class DifferenceRows {
  public:
    /// Pictures of the same size. Reads them once for the largest difference, unless there is a gain.
    DifferenceRows(const PictureView& a, const PictureView& b, double gain);
    /// Writes 3 width numbers to `out`; `buffer` has 3 width numbers.
    void read(std::int32_t y, float* out, float* buffer) const;

  private:
    void subtract(std::int32_t y, float* out, float* buffer) const;

    const PictureView a_, b_;
    float factor_ = 1;
};

/// Marks the pixels of a row that are on an edge (k_edge_step) of a picture in 255ths / unit. `scratch` has 6
/// width numbers.
template <class Number>
void mark_edges(const std::array<const Number*, 3>& above_here_below, std::int32_t width, double unit,
                Number* scratch, std::uint8_t* edges) {
    const auto [above, here, below] = above_here_below;
    const std::int32_t count = 3 * width;
    Number *least = scratch, *most = scratch + count;
    for (std::int32_t i = 0; i < count; ++i) {
        least[i] = std::min(std::min(above[i], here[i]), below[i]);
        most[i] = std::max(std::max(above[i], here[i]), below[i]);
    }
    for (std::int32_t x = 0; x < width; ++x) {
        const std::int32_t left = 3 * std::max(x - 1, 0), right = 3 * std::min(x + 1, width - 1);
        bool is_edge = false;
        for (std::int32_t c = 0; c < 3; ++c) {
            const Number low = std::min(std::min(least[left + c], least[3 * x + c]), least[right + c]),
                         high = std::max(std::max(most[left + c], most[3 * x + c]), most[right + c]);
            is_edge = is_edge || unit * static_cast<double>(high - low) > k_edge_step;
        }
        edges[x] = is_edge;
    }
}

// ---- Structural similarity ----

inline constexpr std::int32_t k_ssim_window = 11;

/// The sums of a window, or of one row or column of it.
struct SsimMoments {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
};

class Ssim {
  public:
    Ssim();
    /// The sum of the similarities of the windows whose first row this is, for pictures of at least
    /// k_ssim_window columns. a, b: the luminance of k_ssim_window rows, row by row. `columns` has `width`
    /// elements.
    double sum_row(const double* a, const double* b, std::int32_t width, SsimMoments* columns) const;

  private:
    std::array<double, k_ssim_window> weights_{};
};

}  // namespace glint
