// SPDX-License-Identifier: Apache-2.0
#pragma once
// Closed lines of points in a plane, and the triangles that fill what an odd number of their edges surrounds.
#include <array>
#include <cstdint>
#include <functional>

#include "base/memory_budget.h"
#include "math/number.h"

namespace glint::povray {

struct FlatPoint {
    double x = 0, y = 0;
};
using FlatLoop = CountedVector<FlatPoint>;
using FlatTriangle = std::array<FlatPoint, 3>;

/// The greatest number of points of a polygon or prism.
inline constexpr std::size_t k_max_loop_points = 4096;

/// Coordinates up to this far apart are the same for POV-Ray's closed lines: 1e-11, and not 1e-9 (measured).
inline constexpr double k_same_point = 1e-10;

inline bool is_same_coordinate(double a, double b) { return number::abs(a - b) <= k_same_point; }
inline bool is_same_point(FlatPoint a, FlatPoint b) {
    return is_same_coordinate(a.x, b.x) && is_same_coordinate(a.y, b.y);
}

/// Calls use(first, end) for each closed line of a list: the first point, when it comes again, ends one, and
/// the next point begins another one. The point that ends it is not part of it. The last one may be open.
template <class Points, class Same, class Use>
void for_each_loop(const Points& points, Same&& is_same, Use&& use) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i == first || !is_same(points[i], points[first])) continue;
        use(first, i);
        first = i + 1;
    }
    if (first < points.size()) use(first, points.size());
}

/// What is between two edges, from one y to another one.
struct FlatTrapezoid {
    FlatPoint low_left, low_right, high_left, high_right;
};

/// Fills the loops, which may cross themselves and each other. spend: counts steps, and returns false to
/// stop. False if it did, or if the edges cross more than 100000 times.
bool fill_even_odd(const CountedVector<FlatLoop>& loops, const std::function<bool(std::uint64_t)>& spend,
                   CountedVector<FlatTrapezoid>& trapezoids);
/// The same, with triangles.
bool fill_even_odd(const CountedVector<FlatLoop>& loops, const std::function<bool(std::uint64_t)>& spend,
                   CountedVector<FlatTriangle>& triangles);

}  // namespace glint::povray
