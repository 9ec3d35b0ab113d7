// SPDX-License-Identifier: Apache-2.0
// The origin of a ray that starts at a surface, by the scene's convention. All epsilons are here.
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

/// A surface point that a ray hit.
template <class T> struct SurfacePoint {
    Vector3<T> point, normal;  // unit normal
    Vector3<T> incoming;       // the direction of the ray that hit it
    T magnitude;  // of the numbers from which the point was computed: |origin| + |point| + |shape|, largest
                  // coordinates
};

/// The origin of a ray from the surface in direction `outgoing` (any length); see enum Offset.
template <class T>
HWY_INLINE Vector3<T> offset_ray_origin(const SurfacePoint<T>& s, Vector3<T> outgoing, Offset offset,
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

/// The origin of a ray through the surface: on the far side, with the same offset.
template <class T>
HWY_INLINE Vector3<T> offset_transmitted_origin(const SurfacePoint<T>& s, Vector3<T> outgoing, Offset offset,
                                                double epsilon) {
    if (offset != Offset::normal && offset != Offset::facing)
        return offset_ray_origin(s, outgoing, offset, epsilon);
    const T e = T(epsilon);
    return s.point + s.normal * select(dot(s.normal, outgoing) < T(0), -e, e);
}

/// The minimum t of a ray that starts at a surface.
HWY_INLINE double offset_t_min(Offset offset, double epsilon) {
    return offset == Offset::ray ? epsilon : 0.0;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
