// SPDX-License-Identifier: Apache-2.0
#pragma once
// Affine maps and vectors, in double, with + - * / and sqrt only.
#include <optional>

#include "glint/vec.h"
#include "math/number.h"

namespace glint {

/// A power of two near the largest component of v (0 for the zero vector). Division by it is exact, and the
/// squares of the quotients neither underflow nor overflow.
inline double binary_size(Vec3 v) {
    const double largest = number::max(number::max(number::abs(v.x), number::abs(v.y)), number::abs(v.z));
    if (!(largest >= 0x1p-1022)) return largest;  // zero or subnormal
    double mantissa;
    return number::exp2_integer(number::split_exponent(largest, mantissa));
}

/// |v| for any finite v.
inline double length(Vec3 v) {
    const double size = binary_size(v);
    if (!(size > 0)) return 0;
    v = v / size;
    return number::sqrt(dot(v, v)) * size;
}

/// v / |v| for any finite v; the zero vector stays zero.
inline Vec3 normalize(Vec3 v) {
    const double size = binary_size(v);
    if (!(size > 0)) return {};
    v = v / size;
    return v / number::sqrt(dot(v, v));
}

/// p -> M p + t.
Vec3 transform_point(const Affine& map, Vec3 p);

/// v -> M v.
Vec3 transform_vector(const Affine& map, Vec3 v);

/// Transforms a normal by world_from_object, given object_from_world: multiplies by its transpose. The normal
/// stays on its side of the surface, also for mirrored maps. Not unit.
Vec3 transform_normal(const Affine& object_from_world, Vec3 n);

/// c_from_a = compose(c_from_b, b_from_a).
Affine compose(const Affine& outer, const Affine& inner);

double determinant(const Affine& map);

/// Nothing if the map is singular in double precision: the determinant is below its rounding errors, or the
/// inverse is not finite.
std::optional<Affine> inverse(const Affine& map);

Affine translation(Vec3 by);
Affine scaling(Vec3 by);

/// Rotations by the right-hand rule about an axis through the origin, in degrees; exact at multiples of 90.
Affine rotation_x(double degrees);
Affine rotation_y(double degrees);
Affine rotation_z(double degrees);

}  // namespace glint
