// SPDX-License-Identifier: Apache-2.0
// A tile from its camera rays to its pixels: nearest hit, surface, light, next rays, again.
#if defined(GLINT_TRACE_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_TILE_INL_H_
#undef GLINT_TRACE_TILE_INL_H_
#else
#define GLINT_TRACE_TILE_INL_H_
#endif

#include "trace/camera_rays-inl.h"
#include "trace/direct_lighting-inl.h"
#include "trace/film-inl.h"
#include "trace/hit_declarations-inl.h"
#include "trace/layers-inl.h"
#include "trace/queue_secondary_rays-inl.h"
#include "trace/surface-inl.h"
#include "trace/tile_culling-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Sums diffuse and specular of all hits over the lights, in the scene's order.
inline void light_hits(const WorldParts& world, TileScratch& s, int generation) {
    const bool count_shadows = generation == 0 && s.first_hits.wanted;
    for (int c = 0; c < 3; ++c) {
        std::fill_n(s.diffuse[c].begin(), s.hits, 0.0);
        std::fill_n(s.specular[c].begin(), s.hits, 0.0);
    }
    for (const Light& light : *world.lights) {
        const int rays = make_shadow_rays(world, light, s);
        if (rays > 0) {
            any_hit(world, s.shadow_rays(), rays, k_packet_size, s.occluded.data());
            if (count_shadows) count_lit(s, s.first_hits.asked, 1), count_lit(s, s.first_hits.blocked, 1);
            apply_occlusion(s);
            if (count_shadows) count_lit(s, s.first_hits.blocked, -1);
            s.counts.shadow += static_cast<std::uint64_t>(rays);
        }
        add_terms(world, light, s);
        if (s.record != nullptr) record_light(world, light, s);
    }
}

/// Adds the light of a batch's rays, those from number `from` of the stream on, to their pixels, group by
/// group.
inline void add_light(const WorldParts& world, TileScratch& s, int first, int from, int generation) {
    TileScratch::GroupEnd begin{from, 0};
    for (int i = 0; i < s.groups; ++i) {
        const TileScratch::GroupEnd end = s.group_end[static_cast<std::size_t>(i)];
        add_misses(world, s, first, begin.rays, end.rays, generation);
        add_hits(world, s, begin.hits, end.hits, generation);
        begin = end;
    }
}

/// The rays of one generation, which are traced: what they find goes to the pixels, what leaves it to the
/// next rays.
inline void shade_batch(const WorldParts& world, TileScratch& s, int first, int from, int to,
                        int generation) {
    const Shading shading = world.settings.shading;
    collect_hits(world, s, first, from, to, generation);
    compute_surfaces(world, s, generation);
    if (generation == 0 && s.first_hits.wanted) store_first_hits(world, s, first, from, to);
    if (shading == Shading::color || shading == Shading::normals) {
        add_misses(world, s, first, from, to, generation);
        add_unlit(world, s);
        if (s.record != nullptr) {
            record_rays(world, s, first, from, to, generation);
            record_unlit(world, s);
        }
        return;
    }
    apply_beer_law(world, s);
    if (s.record != nullptr) record_rays(world, s, first, from, to, generation);
    light_hits(world, s, generation);
    add_light(world, s, first, from, generation);
    if (s.record != nullptr) record_sums(world, s, generation);
    queue_secondary_rays(world, s, generation);
}

/// Whether rays [0, count) of the stream all hit nothing.
inline bool all_missed(const TileScratch& s, int count) {
    for (int i = 0; i < count; i += lane_count<double>()) {
        if (any(load(s.t.data() + i) < Doubles(k_infinity) && first_lanes<double>(count - i))) return false;
    }
    return true;
}

/// One sample of each pixel: the camera's rays and all that come of them, generation after generation.
/// Returns whether any camera ray hit something.
inline bool trace_sample(const WorldParts& world, TileScratch& s) {
    for (int generation = 0; s.rays.size() > 0; ++generation) {
        s.next_rays.clear();
        for (int first = 0; first < s.rays.size(); first += k_stream_size) {
            const int count = number::min(k_stream_size, s.rays.size() - first);
            nearest_hit(world, s.rays.rays(first), count, k_packet_size, s.t.data(), s.slot.data());
            if (generation == 0 && !s.needs_every_stage() && all_missed(s, count)) return false;
            for (int i = 0; i < count; i += k_batch_size) {
                shade_batch(world, s, first, i, number::min(i + k_batch_size, count), generation);
            }
        }
        std::swap(s.rays, s.next_rays);
    }
    return true;
}

void render_tile(const WorldParts& world, const TileJob& job, TileScratch& s) {
    const int samples = world.settings.samples;
    const bool layers = job.layers != nullptr;
    TileRecord* const record = s.record;
    s.first_hits.wanted = layers;
    if (layers) clear_first_hits(s.first_hits);
    if (!s.needs_every_stage() && is_tile_empty(world, job)) {
        s.counts.camera += static_cast<std::uint64_t>(samples) * static_cast<std::uint64_t>(samples) *
                           static_cast<std::uint64_t>(job.width * job.height);
        return fill_background(world, job);
    }
    s.film.clear();
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
            make_camera_rays(world, job, i, j, s.rays);
            s.counts.camera += static_cast<std::uint64_t>(s.rays.size());
            if (is_limited(world)) s.sample_rays.fill(0);
            s.first_hits.is_middle = i == samples / 2 && j == samples / 2;
            if (record != nullptr) s.record = record->begin(j * samples + i) ? record : nullptr;
            if (trace_sample(world, s)) continue;
            if (samples == 1) return fill_background(world, job);
            add_misses(world, s, 0, 0, s.rays.size(), 0);
        }
    }
    s.record = record;
    resolve(world, job, s.film);
    if (layers) write_layers(world, job, s);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
