// SPDX-License-Identifier: Apache-2.0
// Shadow rays: their origins and ends, and the effect of occlusion on the light.
#if defined(GLINT_TRACE_SHADOW_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SHADOW_RAYS_INL_H_
#undef GLINT_TRACE_SHADOW_RAYS_INL_H_
#else
#define GLINT_TRACE_SHADOW_RAYS_INL_H_
#endif

#include <bit>
#include <cstring>

#include "geometry/ray_offset-inl.h"
#include "glint/scene.h"
#include "lighting/light.h"
#include "trace/batches.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The ray between a surface and a light. The rays of a point light are traced from the light to the surface,
/// so that they have a common origin.
template <class T> struct ShadowRay {
    Vector3<T> origin, direction;
    T t_min;
    double t_max;
};
/// The ray to a light in a direction of any length, however far away.
template <class T>
HWY_INLINE ShadowRay<T> endless_shadow_ray(const SurfacePoint<T>& s, Vector3<T> to_light,
                                           const Conventions& rules) {
    const SpawnedRay<T> ray = spawn_ray(s, to_light, rules);
    return {ray.origin, ray.direction, T(ray.t_min), k_infinity};
}
/// The ray of a light at the point `from`. to_light: the vector there.
template <class T>
HWY_INLINE ShadowRay<T> shadow_ray_from(const SurfacePoint<T>& s, Vector3<T> from, Vector3<T> to_light,
                                        const Conventions& rules) {
    if (!rules.shadow_stops_at_light) return endless_shadow_ray(s, to_light, rules);
    const Vector3<T> direction = spawn_ray(s, to_light, rules).origin - from;
    // The source compares the distance of an occluder from the moved origin with the distance of the light
    // from P, so that occluders up to epsilon behind the light count.
    const T t_min = rules.offset == Offset::direction ? T(-rules.epsilon) / length(direction) : T(0);
    return {from, direction, t_min, rules.offset == Offset::ray ? 1 - rules.epsilon : 1.0};
}
/// to_light: the vector to the light's position; for a light without one, a direction of any length.
template <class T>
HWY_INLINE ShadowRay<T> shadow_ray(const SurfacePoint<T>& s, const Light& light, Vector3<T> to_light,
                                   const Conventions& rules) {
    if (!light.has_position()) return endless_shadow_ray(s, to_light, rules);
    const Vector3<T> from{T(light.position.x), T(light.position.y), T(light.position.z)};
    return shadow_ray_from(s, from, to_light, rules);
}

/// Writes the shadow rays of the lanes in `set`, from entry `at` on. one_origin: it is the same in all lanes.
HWY_INLINE void store_shadow_rays(const ShadowRay<Doubles>& ray, bool one_origin, LaneMask<double> set,
                                  ShadowRayBatch& to, int at) {
    if (one_origin) {
        store_vector3(ray.origin, to.origin, at);
    } else {
        compress_vector3(ray.origin, set, to.origin, at);
    }
    compress_vector3(ray.direction, set, to.direction, at);
    compress_store(ray.t_min, set, to.t_min.data() + at);
    store(Doubles(ray.t_max), to.t_max.data() + at);
}

/// Clears the lit bits of the surfaces whose shadow ray is occluded. surfaces: their number.
inline void apply_shadows(const ShadowRayBatch& shadow_rays, int surfaces, LightSampleBatch& samples) {
    const std::uint8_t* occluded = shadow_rays.occluded.data();
    for (int i = 0; i < surfaces; i += lane_count<double>()) {
        std::uint8_t& lit = samples.lit[static_cast<std::size_t>(i / lane_count<double>())];
        const int rays = std::popcount(lit);
        if (rays == 0) continue;
        std::uint64_t flags = 0;  // of all rays of the vector, in memory order
        std::memcpy(&flags, occluded, sizeof(flags));
        if (flags << (64 - 8 * rays) == 0) {
            occluded += rays;
            continue;
        }
        std::uint32_t dark = 0;
        for (std::uint32_t bits = lit; bits != 0; bits &= bits - 1) {
            dark |= bits & (0 - bits) & (0u - *occluded++);  // no branch: it would often be mispredicted
        }
        lit = static_cast<std::uint8_t>(lit & ~dark);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
