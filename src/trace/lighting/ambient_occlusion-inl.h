// SPDX-License-Identifier: Apache-2.0
// Light from all directions (Occlusion of glint/scene.h): the part that arrives at the surfaces, by any-hit
// rays (trace/lighting/ambient_occlusion_rays-inl.h), and what the surfaces reflect of it.
#if defined(GLINT_TRACE_AMBIENT_OCCLUSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_AMBIENT_OCCLUSION_INL_H_
#undef GLINT_TRACE_AMBIENT_OCCLUSION_INL_H_
#else
#define GLINT_TRACE_AMBIENT_OCCLUSION_INL_H_
#endif

#include <algorithm>

#include "trace/lighting/ambient_occlusion_rays-inl.h"
#include "trace/lighting/shadow_visibility-inl.h"
#include "trace/surface/material-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Sorts the hits of a stream by their slots: the entry of each surface. Starts the sums.
inline void sort_hits(const HitBatch& hits, SkyBatch& to) {
    to.count = to.first = 0;
    std::array<std::uint32_t, k_stream_size> slot;
    for (std::size_t i = 0; i < static_cast<std::size_t>(hits.count); ++i) {
        if (hits.slot[i] == k_none) continue;
        const auto surface = static_cast<std::size_t>(to.count++);
        slot[surface] = hits.slot[i];
        to.order[surface] = static_cast<std::uint32_t>(surface);
    }
    std::sort(to.order.begin(), to.order.begin() + to.count, [&](std::uint32_t a, std::uint32_t b) {
        return slot[a] != slot[b] ? slot[a] < slot[b] : a < b;
    });
    const auto count = static_cast<std::size_t>(to.count);
    for (std::size_t e = 0; e < count; ++e) to.place[to.order[e]] = static_cast<std::uint32_t>(e);
    // Vectors of surfaces gather from the entries; lanes after the last surface from the first entry.
    std::fill_n(to.place.begin() + to.count, lane_count<double>(), 0u);
    for (StreamColumn<double>* sum : {&to.arrived[0], &to.arrived[1], &to.arrived[2], &to.blocked})
        std::fill_n(sum->begin(), count, 0.0);
}

/// Copies surfaces to their entries. The first of them has number to.first in the stream.
inline void place_surfaces(const SurfaceBatch& surfaces, SkyBatch& to) {
    const std::uint32_t* const place = to.place.data() + to.first;
    const auto copy = [&](const BatchColumn<double>& from, StreamColumn<double>& column) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(surfaces.count); ++i) column[place[i]] = from[i];
    };
    for (int c = 0; c < 3; ++c) {
        copy(surfaces.point[c], to.surface[c]);
        copy(surfaces.normal[c], to.surface[SkyBatch::k_normal + c]);
        copy(surfaces.incoming[c], to.surface[SkyBatch::k_incoming + c]);
    }
    copy(surfaces.magnitude, to.surface[SkyBatch::k_magnitude]);
    if (surfaces.hashed) copy(surfaces.hash, to.hash);
    to.first += surfaces.count;
}

/// Whether transparent surfaces color the light from all directions.
inline bool colors_sky(const WorldParts& world) { return world.colors_shadows() && world.settings.shadows; }

/// Determines which rays are occluded, and with colored shadows the factor of the light of the others.
inline void find_sky_visibility(const WorldParts& world, ShadowRayBatch& rays, SteppedRays& steps) {
    intersect_shadow(world, rays);
    rays.from_light = false;
    if (world.colors_shadows()) filter_light(world, rays, steps, false, nullptr);
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

/// f of a vector of surfaces, by channel.
HWY_INLINE Vector3<Doubles> sky_factor(const WorldParts& world, const SkyBatch& sky, int h) {
    const Occlusion& occlusion = *world.occlusion;
    const Doubles scale((occlusion.method == OcclusionMethod::fixed ? 2.0 : 1.0) / occlusion.samples);
    const GatherIndices places(sky.place.data() + sky.first + h);
    const auto arrived = [&](int c) HWY_ATTR { return gather(sky.arrived[c].data(), places) * scale; };
    if (colors_sky(world)) return {arrived(0), arrived(1), arrived(2)};
    const Doubles f = arrived(0);
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
