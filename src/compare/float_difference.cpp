// SPDX-License-Identifier: Apache-2.0
#include "compare/float_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/levels.h"

namespace glint {
namespace {

// The part of the difference between 0 and 1 must be at least this fraction to be examined.
constexpr double k_min_visible = 0.1;
// A factor must explain at least this much, and differ from 1 by at least this.
constexpr double k_min_fitted = 0.85, k_min_change = 0.0005;

struct Sums {
    double whole = 0, visible = 0;     // of |a - b|, and of the values clamped to 0 to 1
    double products = 0, squares = 0;  // of a b, and of b b
    std::size_t count = 0;
};

template <class Each> void for_each_finite(const PictureView& a, const PictureView& b, Each&& each) {
    const std::size_t count = std::size_t{3} * b.width;
    std::vector<float> buffer_a(count), buffer_b(count);
    for (std::int32_t y = 0; y < b.height; ++y) {
        const float *of_a = a.row(y, buffer_a.data()), *of_b = b.row(y, buffer_b.data());
        for (std::size_t i = 0; i < count; ++i) {
            if (is_finite(of_a[i]) && is_finite(of_b[i]))
                each(static_cast<double>(of_a[i]), static_cast<double>(of_b[i]));
        }
    }
}

}  // namespace

bool is_beyond_bytes(const PictureView& a, const PictureView& b, bool same_bytes, CauseReport& report) {
    Sums sums;
    for_each_finite(a, b, [&](double x, double y) {
        sums.whole += std::fabs(x - y);
        sums.visible += std::fabs(std::clamp(x, 0.0, 1.0) - std::clamp(y, 0.0, 1.0));
        sums.products += x * y;
        sums.squares += y * y;
        ++sums.count;
    });
    const bool is_visible = sums.visible >= k_min_visible * sums.whole;
    if (sums.whole == 0 || (is_visible && !same_bytes)) return false;
    const double scale = 255 / static_cast<double>(sums.count);
    report.difference = sums.whole * scale;
    const double factor = sums.squares > 0 ? sums.products / sums.squares : 1;
    double left = 0;
    for_each_finite(a, b, [&](double x, double y) { left += std::fabs(x - factor * y); });
    const double explained = 1 - left / sums.whole;
    if (factor > 0 && std::fabs(factor - 1) > k_min_change && explained >= k_min_fitted) {
        report.tried = 1;
        report.causes.push_back(
            {"light-intensity",
             fmt::format(
                 "Everything is {:.5g} times as bright: a light's intensity, or a factor of all lights.",
                 factor),
             explained, left * scale, false});
        return true;
    }
    if (is_visible)
        report.remark = "They differ by less than a byte shows: no cause is looked for.";
    else
        report.remark = fmt::format(
            "{} of the difference is outside 0 to 1, where a picture of bytes is clamped: "
            "no cause is looked for.",
            sums.visible > 0 ? "Nearly all" : "All");
    return true;
}

}  // namespace glint
