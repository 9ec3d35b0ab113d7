// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random points, directions and sizes.
#include <cmath>

#include "glint/vec.h"
#include "math/transform.h"
#include "math/ulp.h"

namespace glint::test {

inline int below(Random& random, int n) {
    return static_cast<int>(random.bits() % static_cast<std::uint64_t>(n));
}
inline bool chance(Random& random, double probability) { return random.uniform(0, 1) < probability; }

/// Every order of magnitude between lo and hi with equal probability.
inline double log_uniform(Random& random, double lo, double hi) {
    return std::exp(random.uniform(std::log(lo), std::log(hi)));
}

inline Vec3 point_in_cube(Random& random, double half) {
    return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

inline Vec3 unit_direction(Random& random) {
    for (;;) {
        const Vec3 v = point_in_cube(random, 1);
        const double size = dot(v, v);
        if (size > 1e-3 && size < 1) return v / std::sqrt(size);
    }
}

/// A unit vector perpendicular to the unit vector n.
inline Vec3 perpendicular(Random& random, Vec3 n) {
    for (;;) {
        const Vec3 v = cross(n, unit_direction(random));
        if (dot(v, v) > 1e-3) return normalize(v);
    }
}

/// Along an axis; the other components are 0 or -0.
inline Vec3 axis_direction(Random& random) {
    double v[3];
    for (double& c : v) c = chance(random, 0.5) ? 0.0 : -0.0;
    v[below(random, 3)] = chance(random, 0.5) ? 1 : -1;
    return {v[0], v[1], v[2]};
}

}  // namespace glint::test
