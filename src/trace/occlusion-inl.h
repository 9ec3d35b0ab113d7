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
    }
    copy(surfaces.magnitude, to.surface[SkyBatch::k_magnitude]);
    if (surfaces.hashed) copy(surfaces.hash, to.hash);
    std::fill_n(to.arrived.begin(), count, 0.0);
    std::fill_n(to.blocked.begin(), count, 0.0);
}

/// Adds the rays to the sums of their surfaces. The order of the rays of a surface is fixed.
inline void add_sky_rays(const ShadowRayBatch& rays, SkyBatch& sky) {
    for (std::size_t r = 0; r < static_cast<std::size_t>(rays.count); ++r) {
        const auto i = static_cast<std::size_t>(sky.entry[r]);
        const double blocked = rays.occluded[r];
        sky.arrived[i] += sky.cosine[r] * (1 - blocked);
        sky.blocked[i] += blocked;
    }
}

/// Determines which rays are occluded.
inline void find_sky_visibility(const WorldParts& world, ShadowRayBatch& rays) {
    any_hit(world, rays.span(), rays.count, k_packet_size, k_sky_spread, rays.occluded.data());
}

/// Puts the sums into the order of the surfaces.
inline void unsort_sky(SkyBatch& sky) {
    const auto count = static_cast<std::size_t>(sky.count);
    for (BatchColumn<double>* sums : {&sky.arrived, &sky.blocked}) {
        std::copy_n(sums->begin(), count, sky.cosine.begin());
        for (std::size_t i = 0; i < count; ++i) (*sums)[sky.order[i]] = sky.cosine[i];
    }
}

/// f of a vector of surfaces.
HWY_INLINE Doubles sky_factor(const Occlusion& occlusion, const SkyBatch& sky, int h) {
    const double scale = occlusion.method == OcclusionMethod::fixed ? 2 : 1;
    return load(sky.arrived.data() + h) * Doubles(scale / occlusion.samples);
}

/// k_d color f.
inline void add_sky(const WorldParts& world, const SurfaceBatch& surfaces, const SkyBatch& sky,
                    RadianceBatch& radiance) {
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        const MaterialLanes material(surfaces, h);
        store_vector3(
            material.color(k_diffuse) * lanes_of(world.occlusion->color) * sky_factor(*world.occlusion, sky, h),
            radiance.sky, h);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
