#pragma once
// Affine maps and vectors, in double, by + - * / and sqrt alone.
#include <optional>

#include "glint/vec.h"
#include "math/number.h"

namespace glint {

/// |v|, of any finite v: squares of very small or large components neither vanish nor overflow.
inline double length(Vec3 v) {
    const double largest = number::max(number::max(number::abs(v.x), number::abs(v.y)), number::abs(v.z));
    if (!(largest > 0)) return 0;
    v = v / largest;
    return number::sqrt(dot(v, v)) * largest;
}

/// v / |v|; v is not 0.
inline Vec3 normalize(Vec3 v) {
    v = v / number::max(number::max(number::abs(v.x), number::abs(v.y)), number::abs(v.z));
    return v / number::sqrt(dot(v, v));
}

/// p -> M p + t.
Vec3 transform_point(const Affine& map, Vec3 p);

/// v -> M v.
Vec3 transform_vector(const Affine& map, Vec3 v);

/// A normal under world_from_object, given object_from_world: its transpose. Not unit.
Vec3 transform_normal(const Affine& object_from_world, Vec3 n);

/// c_from_a = compose(c_from_b, b_from_a).
Affine compose(const Affine& outer, const Affine& inner);

double determinant(const Affine& map);

/// Nothing if the map is singular: its determinant is 0 or not finite, or its inverse is not finite.
std::optional<Affine> inverse(const Affine& map);

Affine translation(Vec3 by);
Affine scaling(Vec3 by);

/// Rotations by the right-hand rule about an axis through the origin, in degrees; exact at multiples of 90.
Affine rotation_x(double degrees);
Affine rotation_y(double degrees);
Affine rotation_z(double degrees);

}  // namespace glint
