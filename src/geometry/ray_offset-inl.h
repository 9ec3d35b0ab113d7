// SPDX-License-Identifier: Apache-2.0
// Rays that start at a surface: their origins and least t, by the scene's convention. All epsilons are here.
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

/// The origin of spawn_ray(); see enum Offset.
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

/// A ray that starts at a surface: t from t_min on.
template <class T> struct SpawnedRay {
    Vector3<T> origin, direction;
    double t_min;
};

/// The ray from the surface in direction `outgoing` (any length): to a light, or reflected.
template <class T>
HWY_INLINE SpawnedRay<T> spawn_ray(const SurfacePoint<T>& s, Vector3<T> outgoing, Offset offset,
                                   double epsilon) {
    return {offset_ray_origin(s, outgoing, offset, epsilon), outgoing, offset == Offset::ray ? epsilon : 0.0};
}
template <class T>
HWY_INLINE SpawnedRay<T> spawn_ray(const SurfacePoint<T>& s, Vector3<T> outgoing, const Conventions& rules) {
    return spawn_ray(s, outgoing, rules.offset, rules.epsilon);
}

/// The ray through the surface: its origin is on the far side, with the same offset.
template <class T>
HWY_INLINE SpawnedRay<T> spawn_transmitted_ray(const SurfacePoint<T>& s, Vector3<T> outgoing,
                                               const Conventions& rules) {
    SpawnedRay<T> ray = spawn_ray(s, outgoing, rules);
    if (rules.offset != Offset::normal && rules.offset != Offset::facing) return ray;
    const T e = T(rules.epsilon);
    ray.origin = s.point + s.normal * select(dot(s.normal, outgoing) < T(0), -e, e);
    return ray;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
