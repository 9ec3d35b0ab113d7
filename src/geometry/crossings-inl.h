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
    to = Crossing<T>(first.valid && last.valid, first.t, -last.t);
}

/// Writes k_crossings / 2 intervals, in ascending order of t. An interval that is not there is empty.
template <class Geometry, class T>
HWY_INLINE void find_crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) {
    if constexpr (requires { Geometry::crossings(p, ray, to); }) {
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
