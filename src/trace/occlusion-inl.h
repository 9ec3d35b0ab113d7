// SPDX-License-Identifier: Apache-2.0
// Light from all directions (Occlusion of glint/scene.h): the part that arrives at the surfaces, by any-hit
// rays (trace/occlusion_rays-inl.h), and what the surfaces reflect of it.
#if defined(GLINT_TRACE_OCCLUSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_OCCLUSION_INL_H_
#undef GLINT_TRACE_OCCLUSION_INL_H_
#else
#define GLINT_TRACE_OCCLUSION_INL_H_
#endif

#include <algorithm>

#include "trace/material-inl.h"
#include "trace/occlusion_rays-inl.h"
#include "trace/transparency-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Starts the sums of the surfaces, and puts them into the order of their slots.
inline void sort_surfaces(const SurfaceBatch& surfaces, SkyBatch& to) {
    to.count = surfaces.count;
    const auto count = static_cast<std::size_t>(surfaces.count);
    for (std::size_t h = 0; h < count; ++h) to.order[h] = static_cast<std::uint32_t>(h);
    std::sort(to.order.begin(), to.order.begin() + surfaces.count, [&](std::uint32_t a, std::uint32_t b) {
        return surfaces.slot[a] != surfaces.slot[b] ? surfaces.slot[a] < surfaces.slot[b] : a < b;
    });
    const auto copy = [&](const BatchColumn<double>& from, BatchColumn<double>& column) {
        for (std::size_t i = 0; i < count; ++i) column[i] = from[to.order[i]];
    };
    for (int c = 0; c < 3; ++c) {
        copy(surfaces.point[c], to.surface[c]);
        copy(surfaces.normal[c], to.surface[SkyBatch::k_normal + c]);
        copy(surfaces.incoming[c], to.surface[SkyBatch::k_incoming + c]);
        std::fill_n(to.arrived[c].begin(), count, 0.0);
    }
    copy(surfaces.magnitude, to.surface[SkyBatch::k_magnitude]);
    if (surfaces.hashed) copy(surfaces.hash, to.hash);
    std::fill_n(to.blocked.begin(), count, 0.0);
}

/// Whether transparent surfaces color the light from all directions.
inline bool colors_sky(const WorldParts& world) { return world.colors_shadows() && world.settings.shadows; }

/// Determines which rays are occluded, and with colored shadows the factor of the light of the others.
inline void find_sky_visibility(const WorldParts& world, ShadowRayBatch& rays, SteppedRays& steps) {
    intersect_shadow(world, rays);
    if (world.colors_shadows()) filter_light(world, rays, steps, nullptr);
}

/// Adds the rays to the sums of their surfaces. The order of the rays of a surface is fixed.
inline void add_sky_rays(const WorldParts& world, const ShadowRayBatch& rays, SkyBatch& sky) {
    const bool colored = colors_sky(world);
    for (std::size_t r = 0; r < static_cast<std::size_t>(rays.count); ++r) {
        const auto i = static_cast<std::size_t>(sky.entry[r]);
        const double blocked = rays.occluded[r];
        sky.blocked[i] += blocked;
        const double arrived = sky.cosine[r] * (1 - blocked);
        if (!colored) {
            sky.arrived[0][i] += arrived;
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) sky.arrived[c][i] += arrived * rays.filter[c][r];
    }
}

/// Puts the sums into the order of the surfaces.
inline void unsort_sky(SkyBatch& sky) {
    const auto count = static_cast<std::size_t>(sky.count);
    for (BatchColumn<double>* sums : {&sky.arrived[0], &sky.arrived[1], &sky.arrived[2], &sky.blocked}) {
        std::copy_n(sums->begin(), count, sky.cosine.begin());
        for (std::size_t i = 0; i < count; ++i) (*sums)[sky.order[i]] = sky.cosine[i];
    }
}

/// f of a vector of surfaces, by channel.
HWY_INLINE Vector3<Doubles> sky_factor(const WorldParts& world, const SkyBatch& sky, int h) {
    const Occlusion& occlusion = *world.occlusion;
    const Doubles scale((occlusion.method == OcclusionMethod::fixed ? 2.0 : 1.0) / occlusion.samples);
    if (colors_sky(world)) return load_vector3(sky.arrived, h) * scale;
    const Doubles f = load(sky.arrived[0].data() + h) * scale;
    return {f, f, f};
}

/// k_d color f.
inline void add_sky(const WorldParts& world, const SurfaceBatch& surfaces, const SkyBatch& sky,
                    RadianceBatch& radiance) {
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        const MaterialLanes material(surfaces, h);
        store_vector3(
            material.color(k_diffuse) * lanes_of(world.occlusion->color) * sky_factor(world, sky, h),
            radiance.sky, h);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
