// SPDX-License-Identifier: Apache-2.0
// The origins and directions of mirror rays and of rays through glass.
#if defined(GLINT_TRACE_SECONDARY_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SECONDARY_RAYS_INL_H_
#undef GLINT_TRACE_SECONDARY_RAYS_INL_H_
#else
#define GLINT_TRACE_SECONDARY_RAYS_INL_H_
#endif

#include "geometry/ray_offset-inl.h"
#include "glint/scene.h"
#include "lighting/glass-inl.h"
#include "lighting/phong-inl.h"
#include "world/tracer_fault.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The mirror ray. glass: the mask of transparent surfaces. On glass a ray is reflected on either side of the
/// surface, so its offset is towards the ray's side, even if the convention offsets along the normal.
template <class T, class M>
HWY_INLINE SpawnedRay<T> mirrored_ray(const SurfacePoint<T>& s, M glass, const Conventions& rules) {
    SpawnedRay<T> ray = spawn_ray(s, mirrored(-s.incoming, s.normal), rules);
    if (rules.offset == Offset::normal)
        ray.origin = select_vector3(glass, spawn_ray(s, ray.direction, Offset::facing, rules.epsilon).origin,
                                    ray.origin);
    return ray;
}

/// The mirror ray with a fault. right: without it. normal_length: that of the faulty N.
template <class T>
HWY_INLINE SpawnedRay<T> faulty_mirror_ray(const SurfacePoint<T>& s, const SpawnedRay<T>& right,
                                           T normal_length, TracerFault fault, const Conventions& rules) {
    switch (fault) {
        case TracerFault::normal_not_unit_anywhere:
            return spawn_ray(s, mirrored(-s.incoming, s.normal * normal_length), rules);
        case TracerFault::mirror_into_surface:
            return spawn_ray(s, s.incoming + s.normal * (T(2) * dot(s.normal, s.incoming)), rules);
        case TracerFault::mirror_negated:
            return spawn_ray(s, -right.direction, rules);
        case TracerFault::mirror_along_surface:
            // Rounding must not decide on which side it starts.
            return spawn_ray(s, s.incoming - s.normal * dot(s.normal, s.incoming),
                             rules.offset == Offset::ray ? Offset::ray : Offset::facing, rules.epsilon);
        default:
            return right;
    }
}

/// The direction of the ray through glass, and the reflected fraction F (Fresnel; 1 for total internal
/// reflection).
template <class T> struct RefractedRay {
    Vector3<T> direction;
    T fresnel;
};
template <class T, class M>
HWY_INLINE RefractedRay<T> refracted_ray(const SurfacePoint<T>& s, M from_inside, T ior,
                                         const Conventions& rules) {
    const T one(1);
    const Vector3<T> facing = select_vector3(dot(s.normal, s.incoming) > T(0), -s.normal, s.normal);
    const auto refraction = refracted(s.incoming, facing, select(from_inside, ior, one / ior));
    T fresnel(0);
    if (rules.fresnel == Fresnel::schlick)
        fresnel = schlick(-dot(facing, s.incoming) / length(s.incoming), ior);
    return {refraction.direction, select(refraction.total, one, fresnel)};
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
