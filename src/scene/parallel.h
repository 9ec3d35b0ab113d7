// SPDX-License-Identifier: Apache-2.0
#pragma once
// Directions of any length, and whether they are parallel.
#include "glint/vec.h"
#include "math/number.h"

namespace glint {

// The sine of the angle below which two directions count as parallel, and similarly for three.
inline constexpr double k_parallel = 1e-9;

// Dividing by the largest component prevents underflow of squares: 1e-200 is a valid direction.
inline Vec3 unit_or_zero(Vec3 v) {
    const double largest = number::max(number::max(number::abs(v.x), number::abs(v.y)), number::abs(v.z));
    if (!(largest > 0)) return {0, 0, 0};
    // The smallest double's reciprocal is infinite, so this divides.
    v = v / largest;
    return v / number::sqrt(dot(v, v));
}

inline bool are_parallel(Vec3 a, Vec3 b) {
    const Vec3 c = cross(unit_or_zero(a), unit_or_zero(b));
    return dot(c, c) < k_parallel * k_parallel;
}

}  // namespace glint
