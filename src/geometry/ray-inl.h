// SPDX-License-Identifier: Apache-2.0
// Rays and the results of intersection formulas, for any number type.
#if defined(GLINT_GEOMETRY_RAY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_RAY_INL_H_
#undef GLINT_GEOMETRY_RAY_INL_H_
#else
#define GLINT_GEOMETRY_RAY_INL_H_
#endif

#include "math/frame.h"
#include "math/number.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Points origin + t direction; the direction has any length except 0.
template <class T> struct Ray { Vector3<T> origin, direction; };

/// A frame for parallel rays, whose z axis is their direction.
struct ParallelFrame : Frame {
    double magnitude = 0;  // at least |x| + |y| + |z| of the rays' origins

    ParallelFrame() = default;
    HWY_INLINE ParallelFrame(Vec3 direction, double magnitude_of_origins)
        : Frame(normalize(direction)), magnitude(magnitude_of_origins) {}
    template <class T> HWY_INLINE Vector3<T> coordinates(const Vector3<T>& point) const {
        const auto on = [&](Vec3 axis) HWY_ATTR {
            return point.x * T(axis.x) + point.y * T(axis.y) + point.z * T(axis.z);
        };
        return {on(x), on(y), on(z)};
    }
};

/// The result of a formula: the smallest t > t_min at which the ray intersects the shape, if `valid`.
template <class T> struct Hit {
    decltype(T() < T()) valid;
    T t;
};

/// The line enters the shape at t = enter and leaves it at exit; enter = infinity and exit = -infinity: it is
/// not inside. A line that touches the surface has enter = exit.
template <class T> struct Crossing {
    T enter, exit;
    HWY_INLINE Crossing() : enter(T(k_infinity)), exit(T(-k_infinity)) {}
    /// From `from` to `to`, if `valid`.
    template <class M>
    HWY_INLINE Crossing(M valid, T from, T to)
        : enter(select(valid, from, T(k_infinity))), exit(select(valid, to, T(-k_infinity))) {}
};

/// The roots b - h and b + h of |q + t d|^2 = r^2, relative to the point of closest approach: q + b d is
/// perpendicular to d, which avoids subtracting large numbers (Haines et al., Precision Improvements for
/// Ray/Sphere Intersection, 2019).
template <class T> struct Roots {
    decltype(T() < T()) real;
    T b, h;
};
template <class T> HWY_INLINE Roots<T> closest_approach(Vector3<T> q, Vector3<T> d, T radius) {
    const T inverse = T(1) / dot(d, d);
    const T b = -(dot(q, d) * inverse);
    const Vector3<T> f = q + d * b;
    const T discriminant = radius * radius - dot(f, f);
    const auto real = discriminant >= T(0);
    if (!any(real)) return {real, b, T(0)};
    return {real, b, sqrt(max(discriminant, T(0)) * inverse)};
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
