// SPDX-License-Identifier: Apache-2.0
// Structural similarity: Wang, Bovik, Sheikh, Simoncelli: "Image Quality Assessment: From Error Visibility to
// Structural Similarity", 2004, with the constants of the authors' own program.
#include <array>

#include "base/parallel_for.h"
#include "image/levels.h"
#include "math/elementary.h"

namespace glint {
namespace {

constexpr std::int32_t k_window = 11;
constexpr double k_sigma = 1.5, k_c1 = (0.01 * 255) * (0.01 * 255), k_c2 = (0.03 * 255) * (0.03 * 255);

using Weights = std::array<double, k_window>;

Weights gaussian() {
    Weights weights{};
    double sum = 0;
    for (int i = 0; i < k_window; ++i) {
        const double d = i - k_window / 2;
        weights[i] = exp(-d * d / (2 * k_sigma * k_sigma));
        sum += weights[i];
    }
    for (double& w : weights) w /= sum;
    return weights;
}

// The sums of a window, or of one row or column of it.
struct Moments {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    void add(double w, const Moments& m) {
        a += w * m.a;
        b += w * m.b;
        aa += w * m.aa;
        bb += w * m.bb;
        ab += w * m.ab;
    }
};

double luminance(const float* rgb) {
    return 0.299 * static_cast<double>(rgb[0]) + 0.587 * static_cast<double>(rgb[1]) +
           0.114 * static_cast<double>(rgb[2]);
}

double similarity(const Moments& m) {
    const double aa = m.aa - m.a * m.a, bb = m.bb - m.b * m.b, ab = m.ab - m.a * m.b;
    return (2 * m.a * m.b + k_c1) * (2 * ab + k_c2) / ((m.a * m.a + m.b * m.b + k_c1) * (aa + bb + k_c2));
}

}  // namespace

std::optional<double> ssim(const Levels& a, const Levels& b, int threads) {
    const std::int32_t width = a.width, height = a.height;
    if (width < k_window || height < k_window) return std::nullopt;
    const Weights weights = gaussian();
    const std::int32_t across = width - k_window + 1, down = height - k_window + 1;
    std::vector<double> rows(static_cast<std::size_t>(down));
    parallel_for(rows.size(), threads, [&](std::size_t y) {
        // First down the window: the moments of every column of the picture.
        std::vector<Moments> columns(static_cast<std::size_t>(width));
        for (int i = 0; i < k_window; ++i) {
            const std::size_t start = 3 * (y + i) * width;
            for (std::int32_t x = 0; x < width; ++x) {
                const double la = a.unit * luminance(&a.values[start + 3 * x]),
                             lb = b.unit * luminance(&b.values[start + 3 * x]);
                columns[x].add(weights[i], {la, lb, la * la, lb * lb, la * lb});
            }
        }
        double sum = 0;
        for (std::int32_t x = 0; x < across; ++x) {
            Moments window;
            for (int i = 0; i < k_window; ++i) window.add(weights[i], columns[x + i]);
            sum += similarity(window);
        }
        rows[y] = sum;
    });
    double sum = 0;
    for (const double row : rows) sum += row;
    return sum / (static_cast<double>(across) * down);
}

}  // namespace glint
