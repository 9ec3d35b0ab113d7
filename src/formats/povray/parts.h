// SPDX-License-Identifier: Apache-2.0
#pragma once
// A triangle in n x n parts of equal size.
#include <array>

namespace glint::povray {

/// The weights of the whole triangle's corners at one corner of a part.
using CornerWeights = std::array<double, 3>;

/// Calls use(weights of the part's three corners), n * n times; stops if it returns false.
template <class Use> void for_each_part(int n, Use&& use) {
    for (int row = 0; row < n; ++row) {
        for (int i = 0; i < 2 * (n - row) - 1; ++i) {
            const int column = i / 2;
            const int upright[3][2] = {{row, column}, {row, column + 1}, {row + 1, column}};
            const int turned[3][2] = {{row + 1, column + 1}, {row + 1, column}, {row, column + 1}};
            const auto& at = i % 2 != 0 ? turned : upright;
            std::array<CornerWeights, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const double v = static_cast<double>(at[k][1]) / n, w = static_cast<double>(at[k][0]) / n;
                corners[k] = {1 - v - w, v, w};
            }
            if (!use(corners)) return;
        }
    }
}

/// Calls use(weights of three corners, weights in the middle of the strip) for the parts of n strips of equal
/// width along the side opposite to corner `apex`, 2 n - 1 times; stops if it returns false.
template <class Use> void for_each_strip(int n, std::size_t apex, Use&& use) {
    const auto at = [&](double height, bool is_second) {
        CornerWeights w{};
        w[apex] = height;
        w[(apex + (is_second ? 2 : 1)) % 3] = 1 - height;
        return w;
    };
    for (int row = 0; row < n; ++row) {
        const double low = static_cast<double>(row) / n, high = static_cast<double>(row + 1) / n;
        const CornerWeights middle = at((low + high) / 2, false);
        if (!use({at(low, false), at(low, true), at(high, false)}, middle)) return;
        if (row + 1 == n) return;
        if (!use({at(low, true), at(high, true), at(high, false)}, middle)) return;
    }
}

/// The mean of three values by weights.
template <class T> T mixed(const T& a, const T& b, const T& c, const CornerWeights& w) {
    return a * w[0] + b * w[1] + c * w[2];
}

}  // namespace glint::povray
