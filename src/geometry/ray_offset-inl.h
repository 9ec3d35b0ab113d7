// SPDX-License-Identifier: Apache-2.0
// How a ray leaves a surface: where it starts, by the scene's convention. The one place with epsilons.
#if defined(GLINT_GEOMETRY_RAY_OFFSET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_RAY_OFFSET_INL_H_
#undef GLINT_GEOMETRY_RAY_OFFSET_INL_H_
#else
#define GLINT_GEOMETRY_RAY_OFFSET_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "glint/conventions.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// A surface point as a ray found it.
template <class T> struct SurfacePoint {
    Triple<T> point, normal;  // unit normal
    Triple<T> incoming;       // the direction of the ray that came
    T magnitude;  // of the numbers the point was computed from: |origin| + |point| + |shape|, largest
                  // coordinates
};

/// Where a ray in direction `outgoing` (any length) from the surface starts (see enum Offset).
template <class T>
HWY_INLINE Triple<T> offset_ray_origin(const SurfacePoint<T>& s, Triple<T> outgoing, Offset offset,
                                       double epsilon) {
    const T e = T(epsilon);
    switch (offset) {
        case Offset::ray:
            return s.point;
        case Offset::normal:
            return s.point + s.normal * e;
        case Offset::facing:
            return s.point + s.normal * select(dot(s.normal, s.incoming) > T(0), -e, e);
        case Offset::direction:
            return s.point + outgoing * (e / length(outgoing));
        case Offset::scale:
            break;
    }
    const T reach = e * s.magnitude;
    return s.point + s.normal * select(dot(s.normal, outgoing) < T(0), -reach, reach);
}

/// Where a ray through the surface starts: on the side it goes to, as far from it as one that leaves.
template <class T>
HWY_INLINE Triple<T> offset_transmitted_origin(const SurfacePoint<T>& s, Triple<T> outgoing, Offset offset,
                                               double epsilon) {
    if (offset != Offset::normal && offset != Offset::facing)
        return offset_ray_origin(s, outgoing, offset, epsilon);
    const T e = T(epsilon);
    return s.point + s.normal * select(dot(s.normal, outgoing) < T(0), -e, e);
}

/// The least t of a ray that leaves a surface.
HWY_INLINE double offset_t_min(Offset offset, double epsilon) {
    return offset == Offset::ray ? epsilon : 0.0;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
