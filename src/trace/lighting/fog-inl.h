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
#include "world/world.h"

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

/// The background and the fog before it, as a ray with weight 1 sees them. inside: the ray is inside an
/// object (FogInteriors).
struct FoggedBackground {
    double visibility = 1;
    Color background, fog;
};
inline FoggedBackground fogged_background(const WorldParts& world, Color color, bool inside) {
    if (!world.fog || !world.conventions.fog_background || !world.has_lighting() || inside)
        return {1, color, {}};
    const double f = world.fog->transmit;
    return {f, color * f, world.fog->color * (1 - f)};
}

/// Multiplies the weights of surfaces by f, and computes the light of the fog in front of them.
inline void apply_fog(const WorldParts& world, SurfaceBatch& surfaces) {
    if (!world.fog) return;
    const bool by_depth = world.conventions.fog_distance == FogDistance::depth && surfaces.generation == 0;
    const Vector3<Doubles> forward = lanes_of(glint::normalize(world.camera.forward));
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        const Vector3<Doubles> d = load_vector3(surfaces.incoming, h);
        const Doubles scale = by_depth ? dot(d, forward) : length(d);
        Doubles f = fog_visibility(*world.fog, load(surfaces.hit_t.data() + h) * scale);
        if (surfaces.tracked) f = select(load(surfaces.interiors.data() + h) > Doubles(0), Doubles(1), f);
        const Vector3<Doubles> weight = load_vector3(surfaces.weight, h);
        store(f, surfaces.visibility.data() + h);
        store_vector3(weight * lanes_of(world.fog->color) * (Doubles(1) - f), surfaces.fog, h);
        store_vector3(weight * f, surfaces.weight, h);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
