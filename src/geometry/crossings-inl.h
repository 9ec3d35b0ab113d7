// SPDX-License-Identifier: Apache-2.0
// Where a line is inside a shape: for the operands of solids.
#if defined(GLINT_GEOMETRY_CROSSINGS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_CROSSINGS_INL_H_
#undef GLINT_GEOMETRY_CROSSINGS_INL_H_
#else
#define GLINT_GEOMETRY_CROSSINGS_INL_H_
#endif

#include "geometry/kinds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Of a convex shape: its first hit, and that of the opposite direction.
template <class Geometry, class T>
HWY_INLINE void find_convex(const T* p, const Ray<T>& ray, Crossing<T>& to) {
    const Hit<T> first = Geometry::hit(p, ray, T(-k_infinity));
    const Hit<T> last = Geometry::hit(p, Ray<T>{ray.origin, -ray.direction}, T(-k_infinity));
    const auto valid = first.valid && last.valid;
    to.enter = select(valid, first.t, T(k_infinity));
    to.exit = select(valid, -last.t, T(-k_infinity));
}

/// Of a half-space: the whole line, a half of it, or nothing.
template <class T> HWY_INLINE void find_half_space(const T* p, const Ray<T>& ray, Crossing<T>& to) {
    const Vector3<T> n = vector3(p + 3);
    const T above = dot(ray.origin - vector3(p), n), slope = dot(ray.direction, n), t = -above / slope;
    const T infinity(k_infinity);
    const auto falls = slope<T(0), rises = slope> T(0), inside = above <= T(0);
    to.enter = select(falls, t, select(rises || inside, -infinity, infinity));
    to.exit = select(rises, t, select(falls || inside, infinity, -infinity));
}

/// Writes k_crossings / 2 intervals, in ascending order of t. An interval that is not there is empty.
template <class Geometry, class T>
HWY_INLINE void find_crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) {
    if constexpr (std::is_same_v<Geometry, PlaneGeometry>) {
        find_half_space(p, ray, *to);
    } else if constexpr (requires { Geometry::crossings(p, ray, to); }) {
        Geometry::crossings(p, ray, to);
    } else {
        static_assert(Geometry::k_crossings == 2);
        find_convex<Geometry>(p, ray, *to);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
