// SPDX-License-Identifier: Apache-2.0
// Refraction of the rays that transparent surfaces let through (Material::refracts).
#if defined(GLINT_TRACE_TRANSPARENT_REFRACTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_TRANSPARENT_REFRACTION_INL_H_
#undef GLINT_TRACE_TRANSPARENT_REFRACTION_INL_H_
#else
#define GLINT_TRACE_TRANSPARENT_REFRACTION_INL_H_
#endif

#include <algorithm>

#include "lighting/glass-inl.h"
#include "trace/batches.h"
#include "trace/secondary/ray_weights-inl.h"
#include "world/appearance/appearance.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The factors of the light that leaves objects through the surfaces whose bits are set
/// (Material::fade_distance). left: left_by_mirror().
GLINT_SMALL Vector3<Doubles> fades_at(const WorldParts& world, const SurfaceBatch& surfaces, int h,
                                      std::uint32_t through, const Vector3<Doubles>& left) noexcept {
    alignas(k_ray_alignment) double left_of[3][lane_count<double>()];
    store_vector3(left, left_of, 0);
    alignas(k_ray_alignment) double factors[3][lane_count<double>()];
    for (auto& channel : factors) std::fill_n(channel, lane_count<double>(), 1.0);
    for (std::uint32_t bits = through; bits != 0; bits &= bits - 1) {
        const int k = __builtin_ctz(bits);
        const Color fade =
            surface_fade(world, surfaces, h + k, {left_of[0][k], left_of[1][k], left_of[2][k]});
        factors[0][k] = fade.r;
        factors[1][k] = fade.g;
        factors[2][k] = fade.b;
    }
    return load_vector3(factors, 0);
}

/// Refracts the rays of those transparent surfaces (`through`) that refract: sets b.refracted_direction, and
/// gives all light, times `fade`, to the mirror ray where there is total reflection (POV-Ray, measured).
/// Returns the surfaces whose rays have another direction.
GLINT_SMALL LaneMask<double> refract_straight_rays(const WorldParts& world, const SurfaceBatch& surfaces,
                                                   int h, const SurfacePoint<Doubles>& surface,
                                                   LaneMask<double> through, const Vector3<Doubles>& fade,
                                                   SecondaryWeights& b) noexcept {
    const Doubles ratio = index_ratios(world, surfaces, h, to_bits(through)), one(1), zero(0);
    const auto bent = ratio < one || ratio > one;
    if (!any(bent)) return bent;
    const auto away = dot(surface.normal, surface.incoming) > zero;
    const Vector3<Doubles> facing = select_vector3(away, -surface.normal, surface.normal);
    const auto refraction = refracted(surface.incoming, facing, ratio);
    const auto total = bent && refraction.total;
    b.refracted_direction = select_vector3(bent, refraction.direction, b.refracted_direction);
    b.reflected = select_vector3(total, load_vector3(surfaces.weight, h) * fade, b.reflected);
    b.transmitted = select_vector3(total, b.transmitted * zero, b.transmitted);
    b.fresnel = select(total, one, b.fresnel);
    return bent;
}

/// RayFields::interiors of the rays `of` through a vector of surfaces.
GLINT_SMALL Doubles passed_interiors(const WorldParts& world, const SurfaceBatch& surfaces, int h,
                                     LaneMask<double> of) noexcept {
    alignas(k_ray_alignment) double inside[lane_count<double>()] = {};
    for (std::uint32_t bits = to_bits(of); bits != 0; bits &= bits - 1) {
        const int k = __builtin_ctz(bits);
        const auto at = static_cast<std::size_t>(h + k);
        inside[k] = pass_surface(world, surfaces.surface(h + k), surfaces.interiors[at]).inside;
    }
    return load(inside);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
