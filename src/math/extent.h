// SPDX-License-Identifier: Apache-2.0
#pragma once
// The extent of points and discs along the axes, in double; used for the boxes of shapes.
#include <limits>

#include "glint/vec.h"
#include "math/number.h"

namespace glint {

struct Extent {
    static constexpr double k_infinity = std::numeric_limits<double>::infinity();
    Vec3 lo{k_infinity, k_infinity, k_infinity}, hi{-k_infinity, -k_infinity, -k_infinity};

    void add(Vec3 p) {
        lo = {number::min(lo.x, p.x), number::min(lo.y, p.y), number::min(lo.z, p.z)};
        hi = {number::max(hi.x, p.x), number::max(hi.y, p.y), number::max(hi.z, p.z)};
    }

    /// Adds a disc: with unit normal n, it extends r sqrt(1 - n_i^2) along axis i.
    void add_disc(Vec3 center, Vec3 n, double radius) {
        const auto reach = [&](double a) { return radius * number::sqrt(number::max(0.0, 1 - a * a)); };
        const Vec3 r{reach(n.x), reach(n.y), reach(n.z)};
        add(center - r);
        add(center + r);
    }
};

}  // namespace glint
