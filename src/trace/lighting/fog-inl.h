// SPDX-License-Identifier: Apache-2.0
// Fog (glint/scene.h): what of the light along a ray is seen, and what the fog adds.
#if defined(GLINT_TRACE_FOG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FOG_INL_H_
#undef GLINT_TRACE_FOG_INL_H_
#else
#define GLINT_TRACE_FOG_INL_H_
#endif

#include "math/transform.h"
#include "simd/elementary-inl.h"
#include "simd/vec3-inl.h"
#include "trace/batches.h"
#include "trace/lighting/ground_fog.h"
#include "world/appearance/appearance.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// f, the part of the light from this distance that is seen.
template <class T> HWY_INLINE T fog_visibility(const Fog& fog, T distance) {
    const T from_start = distance - T(fog.start);
    T f(1);
    if (fog.kind == FogKind::linear) {
        f = (T(fog.end) - distance) / T(fog.end - fog.start);
    } else if (fog.kind == FogKind::exp) {
        f = exp(-(T(fog.density) * from_start));
    } else {
        const T x = T(fog.density) * from_start;
        f = exp(-(x * x));
    }
    return min(max(f, T(fog.transmit)), T(1));
}

/// The distance that fog depends on, of a point at t = 1, for rays of a generation with these directions.
HWY_INLINE Doubles fog_scale(const WorldParts& world, int generation, const Vector3<Doubles>& direction) {
    if (world.conventions.fog_distance == FogDistance::depth && generation == 0)
        return dot(direction, lanes_of(glint::normalize(world.camera.forward)));
    return length(direction);
}

/// The least falloff that counts: heights in its units are finite.
constexpr double k_least_falloff = 1e-9;

/// f of fog on the ground, from points on lines with these directions on. scale: the fog's distance by t.
HWY_NOINLINE inline Doubles ground_fog_visibility(const Fog& fog, const Vector3<Doubles>& from,
                                                  const Vector3<Doubles>& direction, Doubles scale,
                                                  Doubles t) noexcept {
    const Vector3<Doubles> up = lanes_of(glint::normalize(fog.up));
    const double unit = number::max(fog.falloff, k_least_falloff);
    constexpr int k_lanes = lane_count<double>();
    alignas(k_ray_alignment) double height[k_lanes], slope[k_lanes], begin[k_lanes], end[k_lanes];
    store((dot(from, up) - Doubles(fog.height)) / Doubles(unit), height);
    store(dot(direction, up) / Doubles(unit), slope);
    store(Doubles(fog.start) / scale, begin);
    store(t, end);
    for (int k = 0; k < k_lanes; ++k) end[k] = fog_along({height[k], slope[k]}, begin[k], end[k]);
    const Doubles f = exp(-(Doubles(fog.density) * (load(end) * scale)));
    return min(max(f, Doubles(fog.transmit)), Doubles(1));
}

/// Whether rays that leave the scene outside of objects see the background through fog.
HWY_INLINE bool has_fog_on_background(const WorldParts& world) {
    return world.fog && world.conventions.fog_background && world.has_lighting();
}

/// f of the background for a vector of rays outside of objects.
HWY_INLINE Doubles background_visibility(const WorldParts& world, const RayBatch& rays, int ray) {
    if (!has_fog_on_background(world)) return Doubles(1);
    const Fog& fog = *world.fog;
    if (!fog.is_on_ground()) return Doubles(fog.transmit);
    const Vector3<Doubles> direction = load_vector3(rays.direction, ray);
    Vector3<Doubles> from = load_vector3(rays.origin, ray);
    const bool passed = rays.transparent && rays.generation > 0;
    if (passed) from = from + direction * load(rays.start.data() + ray);
    return ground_fog_visibility(fog, from, direction, fog_scale(world, rays.generation, direction),
                                 Doubles(k_infinity));
}

/// The background and the fog before it, as a ray with weight 1 sees them through this visibility.
struct FoggedBackground {
    double visibility = 1;
    Color background, fog;
};
inline FoggedBackground fogged_background(const WorldParts& world, Color color, double visibility) {
    if (!(visibility < 1)) return {1, color, {}};
    return {visibility, color * visibility * world.fog_tint, world.fog->color * (1 - visibility)};
}

/// Light that is seen through fog: f of it, and where there is fog, tinted (Fog::filter).
HWY_INLINE Vector3<Doubles> through_fog(const WorldParts& world, const Vector3<Doubles>& light, Doubles f) {
    const auto in_fog = f < Doubles(1);
    return light * f * select_vector3(in_fog, lanes_of(world.fog_tint), lanes_of(Color{1, 1, 1}));
}

/// Which rays of a vector have no fog, by their RayFields::interiors.
HWY_INLINE LaneMask<double> are_outside_fog(const WorldParts& world, const double* interiors) {
    if (!world.interiors.has_hollow)
        return load(interiors) > Doubles(world.interiors.without_fog ? 0 : k_infinity);
    std::uint32_t bits = 0;
    for (int k = 0; k < lane_count<double>(); ++k)
        bits |= (is_outside_fog(world, interiors[k]) ? 1u : 0u) << k;
    return from_bits<double>(bits);
}

/// Multiplies the weights of surfaces by f, and computes the light of the fog in front of them.
inline void apply_fog(const WorldParts& world, SurfaceBatch& surfaces) {
    if (!world.fog) return;
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        const Vector3<Doubles> d = load_vector3(surfaces.incoming, h);
        const Doubles scale = fog_scale(world, surfaces.generation, d), t = load(surfaces.hit_t.data() + h);
        Doubles f(1);
        if (world.fog->is_on_ground()) {
            f = ground_fog_visibility(*world.fog, load_vector3(surfaces.point, h) - d * t, d, scale, t);
        } else {
            f = fog_visibility(*world.fog, t * scale);
        }
        if (surfaces.tracked)
            f = select(are_outside_fog(world, surfaces.interiors.data() + h), Doubles(1), f);
        const Vector3<Doubles> weight = load_vector3(surfaces.weight, h);
        store(f, surfaces.visibility.data() + h);
        store_vector3(weight * lanes_of(world.fog->color) * (Doubles(1) - f), surfaces.fog, h);
        store_vector3(through_fog(world, weight, f), surfaces.weight, h);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
