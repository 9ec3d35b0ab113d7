// SPDX-License-Identifier: Apache-2.0
// The weights of rays: the factors of a surface's own light, of its mirror ray and of its glass ray in the
// pixel. docs/lighting.md derives the sum over all rays from the recursion.
#if defined(GLINT_TRACE_RAY_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_RAY_WEIGHTS_INL_H_
#undef GLINT_TRACE_RAY_WEIGHTS_INL_H_
#else
#define GLINT_TRACE_RAY_WEIGHTS_INL_H_
#endif

#include "trace/batches.h"
#include "trace/secondary/secondary_rays-inl.h"
#include "trace/surface/finish-inl.h"
#include "trace/surface/material-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The surfaces that start no secondary rays, because of the limit of reflections.
HWY_INLINE LaneMask<double> are_at_limit(const WorldParts& world, const SurfaceBatch& surfaces, int h) {
    const int limit = world.settings.reflections;
    if (!surfaces.transparent)
        return first_lanes<double>(surfaces.generation >= limit ? lane_count<double>() : 0);
    return load(surfaces.level.data() + h) >= Doubles(static_cast<double>(limit));
}

/// The factors of a surface's own light: of ambient and diffuse light, and of the highlight.
struct LocalShares {
    Doubles matte, highlight;
};
/// a: mirror, f: transmission. MirrorRule::blend: (1-f)(1-a); add: 1. With LimitRule::keep it is 1 in the
/// last generation. Of transparent surfaces also times the opacity, by the convention `transparency`.
/// plain: the world uses no extended fields.
template <bool plain = false>
HWY_INLINE LocalShares local_shares(const WorldParts& world, const MaterialLanes& material,
                                    const SurfaceBatch& surfaces, int h) {
    const Conventions& rules = world.conventions;
    const bool keep = rules.limit == LimitRule::keep;
    if (plain || !surfaces.transparent) {
        const bool at_limit = surfaces.generation >= world.settings.reflections;
        if (rules.mirror == MirrorRule::add || (at_limit && keep)) return {Doubles(1), Doubles(1)};
        const Doubles share = (Doubles(1) - material.value(k_transmission)) *
                              (Doubles(1) - mirror_of<plain>(world, material, surfaces, h));
        return {share, share};
    }
    const Doubles one(1);
    Doubles share = rules.mirror == MirrorRule::add ? one
                                                    : (one - material.value(k_transmission)) *
                                                          (one - mirror_of(world, material, surfaces, h));
    Doubles opacity = transparency_of(world, material, surfaces, h).opacity(rules.opacity);
    if (keep) {
        const auto at_limit = are_at_limit(world, surfaces, h);
        share = select(at_limit, one, share);
        opacity = select(at_limit, one, opacity);
    }
    switch (rules.transparency) {
        case Transparency::highlights:
            return {share * opacity, share};
        case Transparency::blend:
            return {share * opacity, share * opacity};
        case Transparency::add:
            break;
    }
    return {share, share};
}

/// The weights of the mirror ray and the glass ray of a hit. a: mirror_of(). F: the fraction of light that
/// glass reflects.
///   reflected: tint ((1-f) a + f F) with blend, tint (a + f F) with add; transmitted: tint f (1-F).
struct SecondaryWeights {
    Vector3<Doubles> reflected, transmitted;  // weights
    Vector3<Doubles> refracted_direction;     // direction of the transmitted ray
    Doubles fresnel;                          // F
};
template <bool plain>
HWY_INLINE SecondaryWeights secondary_weights(const WorldParts& world, const MaterialLanes& material,
                                              const SurfacePoint<Doubles>& surface, Doubles a,
                                              LaneMask<double> glass, LaneMask<double> from_inside,
                                              Vector3<Doubles> weight) {
    const Conventions& rules = world.conventions;
    const Doubles f = material.value(k_transmission), one(1);
    SecondaryWeights b{weight, weight, weight, Doubles(0)};
    Doubles mirror = rules.mirror == MirrorRule::blend ? (one - f) * a : a;
    if (any(glass)) {  // otherwise the transmitted ray is not used
        const Doubles ior = material.value(k_ior);
        const RefractedRay<Doubles> ray = refracted_ray(surface, from_inside, ior, rules);
        const Doubles fresnel = ray.fresnel;
        b.refracted_direction = ray.direction;
        b.fresnel = fresnel;
        mirror = select(glass, mirror + f * fresnel, mirror);
        b.transmitted = weight * select(glass, f * (one - fresnel), Doubles(0));
        // Without Beer's law, light through glass is tinted once, where the ray enters.
        if (!(rules.beer > 0)) {
            const Vector3<Doubles> tinted = b.transmitted * material.color(k_transmission_tint);
            b.transmitted = select_vector3(from_inside, b.transmitted, tinted);
        }
    }
    b.reflected = weight * mirror * mirror_tint_of<plain>(world, material, surface.normal, surface.incoming);
    return b;
}

/// Completes the weights for transparent surfaces (`through`): that of the ray straight through is
/// seen_through(). a: mirror_of().
HWY_INLINE void weight_straight_rays(const WorldParts& world, const MaterialLanes& material,
                                     const SurfaceBatch& surfaces, int h, Doubles a, LaneMask<double> through,
                                     Vector3<Doubles> weight, SecondaryWeights& b) {
    const Conventions& rules = world.conventions;
    const TransparencyLanes transparency = transparency_of(world, material, surfaces, h);
    b.transmitted = select_vector3(
        through, weight * seen_through(world, material, transparency, surfaces, h, a), b.transmitted);
    b.fresnel = select(through, Doubles(0), b.fresnel);
    if (rules.transparency == Transparency::blend)
        b.reflected = select_vector3(through, b.reflected * transparency.opacity(rules.opacity), b.reflected);
}

/// LimitRule::background: the weights of the rays that see the background are those of the rays before them
/// (Tachyon), and with Transparency::blend the mirror ray's is reduced by the opacity.
inline void weight_rays_at_limit(const WorldParts& world, const MaterialLanes& material,
                                 const SurfaceBatch& surfaces, int h, Doubles a, LaneMask<double> at_limit,
                                 LaneMask<double> through, Vector3<Doubles> weight, SecondaryWeights& b) {
    b.transmitted = select_vector3(at_limit, weight, b.transmitted);
    const auto mirror = at_limit && a > Doubles(0);
    if (world.has_transparency() && world.conventions.transparency == Transparency::blend) {
        const Doubles opacity =
            transparency_of(world, material, surfaces, h).opacity(world.conventions.opacity);
        weight = select_vector3(through, weight * opacity, weight);
    }
    b.reflected = select_vector3(mirror, weight, b.reflected);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
