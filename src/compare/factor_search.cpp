// SPDX-License-Identifier: Apache-2.0
#include "compare/factor_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace glint {
namespace {

constexpr int k_sections = 10;  // the remaining interval is 2% of two octaves
constexpr double k_golden = 0.6180339887498949;

// Rounds to two digits: 1.52 to 1.5, 0.33 to 1/3.
double rounded(double factor) {
    if (factor < 1) return 1 / rounded(1 / factor);
    const double unit = factor < 10 ? 0.1 : 1;
    return std::floor(factor / unit + 0.5) * unit;
}

}  // namespace

TriedFactor refine_factor(TriedFactor known, double low, double high, double enough,
                          const LeftByFactor& left_by) {
    const auto try_factor = [&](double factor) {
        const double left = left_by(factor).value_or(HUGE_VAL);
        if (left < known.left) known = {factor, left};
        return left;
    };
    double first = log(low), last = log(high);
    double a = last - k_golden * (last - first), b = first + k_golden * (last - first);
    double at_a = try_factor(exp(a)), at_b = try_factor(exp(b));
    for (int i = 2; i < k_sections && known.left > enough; ++i) {
        if (at_a < at_b) {
            last = b;
            b = a;
            at_b = at_a;
            a = last - k_golden * (last - first);
            at_a = try_factor(exp(a));
        } else {
            first = a;
            a = b;
            at_a = at_b;
            b = first + k_golden * (last - first);
            at_b = try_factor(exp(b));
        }
    }
    if (known.left > enough) try_factor(rounded(known.factor));
    return known;
}

double factor_of_most(const std::vector<WantedValue>& values, double near) {
    constexpr double k_half = 0.5 / 255, k_within = 0.01;
    // Of little light, rounding leaves more than that open.
    double largest = 0;
    for (const auto& [wanted, part] : values) largest = std::max(largest, std::fabs(part));
    if (largest == 0) return near;
    const double within = std::max(k_within * near, k_half / largest);
    std::vector<std::pair<double, int>> ends;  // of the factors that give each byte: 1 begins, -1 ends
    for (const auto& [wanted, part] : values) {
        if (part == 0) continue;
        const auto [first, last] = std::minmax({(wanted - k_half) / part, (wanted + k_half) / part});
        if (last < near - within || first > near + within) continue;
        ends.emplace_back(first, 1);
        ends.emplace_back(last, -1);
    }
    std::sort(ends.begin(), ends.end());
    std::size_t open = 0, most = values.size() / 2;
    double best = near;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        open = ends[i].second > 0 ? open + 1 : open - 1;
        if (open <= most) continue;
        most = open;
        best = (ends[i].first + ends[i + 1].first) / 2;
    }
    return best;
}

std::string factor_text(double factor, bool about) {
    if (factor == 0.25) return "a quarter of";
    if (factor == 0.5) return "half";
    if (factor == 2) return "twice";
    return factor == 4 ? "four times" : fmt::format("{}{:.3g} times", about ? "about " : "", factor);
}

}  // namespace glint
