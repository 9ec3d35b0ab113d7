// SPDX-License-Identifier: Apache-2.0
// Structural similarity: Wang, Bovik, Sheikh, Simoncelli: "Image Quality Assessment: From Error Visibility to
// Structural Similarity", 2004, with the constants of the authors' own program.
#include "image/levels.h"
#include "math/elementary.h"

namespace glint {
namespace {

constexpr double k_sigma = 1.5, k_c1 = (0.01 * 255) * (0.01 * 255), k_c2 = (0.03 * 255) * (0.03 * 255);

void add(SsimMoments& to, double w, const SsimMoments& m) {
    to.a += w * m.a;
    to.b += w * m.b;
    to.aa += w * m.aa;
    to.bb += w * m.bb;
    to.ab += w * m.ab;
}

double similarity(const SsimMoments& m) {
    const double aa = m.aa - m.a * m.a, bb = m.bb - m.b * m.b, ab = m.ab - m.a * m.b;
    return (2 * m.a * m.b + k_c1) * (2 * ab + k_c2) / ((m.a * m.a + m.b * m.b + k_c1) * (aa + bb + k_c2));
}

}  // namespace

Ssim::Ssim() {
    double sum = 0;
    for (int i = 0; i < k_ssim_window; ++i) {
        const double d = i - k_ssim_window / 2;
        weights_[i] = exp(-d * d / (2 * k_sigma * k_sigma));
        sum += weights_[i];
    }
    for (double& w : weights_) w /= sum;
}

double Ssim::sum_row(const double* a, const double* b, std::int32_t width, SsimMoments* columns) const {
    // First down the window: the moments of every column of the picture.
    std::fill_n(columns, width, SsimMoments{});
    for (int i = 0; i < k_ssim_window; ++i) {
        for (std::int32_t x = 0; x < width; ++x) {
            const double la = a[static_cast<std::ptrdiff_t>(i) * width + x],
                         lb = b[static_cast<std::ptrdiff_t>(i) * width + x];
            add(columns[x], weights_[i], {la, lb, la * la, lb * lb, la * lb});
        }
    }
    double sum = 0;
    for (std::int32_t x = 0; x + k_ssim_window <= width; ++x) {
        SsimMoments window;
        for (int i = 0; i < k_ssim_window; ++i) add(window, weights_[i], columns[x + i]);
        sum += similarity(window);
    }
    return sum;
}

}  // namespace glint
