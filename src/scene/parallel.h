// SPDX-License-Identifier: Apache-2.0
#pragma once
// Directions of any length, and whether they are parallel.
#include "glint/vec.h"
#include "math/number.h"

namespace glint {

// Sine of the angle under which two directions count as parallel, and the like for three.
inline constexpr double k_parallel = 1e-9;

// Dividing by the largest component keeps squares from underflowing: 1e-200 is a direction like any other.
inline Vec3 unit_or_zero(Vec3 v) {
    const double largest = number::max(number::max(number::abs(v.x), number::abs(v.y)), number::abs(v.z));
    if (!(largest > 0)) return {0, 0, 0};
    // The smallest double's reciprocal is infinite; dividing is not.
    v = v / largest;
    return v / number::sqrt(dot(v, v));
}

inline bool are_parallel(Vec3 a, Vec3 b) {
    const Vec3 c = cross(unit_or_zero(a), unit_or_zero(b));
    return dot(c, c) < k_parallel * k_parallel;
}

}  // namespace glint
