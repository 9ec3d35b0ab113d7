// SPDX-License-Identifier: Apache-2.0
// Renders pixels with the same number of samples each: calls the stages, from camera rays to pixels.
#if defined(GLINT_TRACE_UNIFORM_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_UNIFORM_TILE_INL_H_
#undef GLINT_TRACE_UNIFORM_TILE_INL_H_
#else
#define GLINT_TRACE_UNIFORM_TILE_INL_H_
#endif

#include "trace/film/film-inl.h"
#include "trace/film/layers-inl.h"
#include "trace/hits/intersect-inl.h"
#include "trace/hits/skip_transparent-inl.h"
#include "trace/lighting/absorption-inl.h"
#include "trace/lighting/ambient_occlusion-inl.h"
#include "trace/lighting/area_shadow-inl.h"
#include "trace/lighting/direct_lighting-inl.h"
#include "trace/lighting/fog-inl.h"
#include "trace/lighting/shadow_visibility-inl.h"
#include "trace/rays/camera_rays-inl.h"
#include "trace/rays/ray_hash-inl.h"
#include "trace/rays/tile_culling-inl.h"
#include "trace/secondary/queue_secondary_rays-inl.h"
#include "trace/surface/collect_hits-inl.h"
#include "trace/surface/color_surfaces-inl.h"
#include "trace/surface/locate_surfaces-inl.h"
#include "trace/surface/record_surfaces-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Runs the stages of one light, or of one sample of an area light.
inline void light_from(const WorldParts& world, const PreparedLight& light, TileScratch& s) {
    FirstHits* const first_hits = s.surfaces.generation == 0 && s.first_hits.wanted ? &s.first_hits : nullptr;
    const LightRules rules = light_rules(world, light);
    sample_light(world, light, rules, s.surfaces, s.light_samples, s.shadow_rays);
    if (s.shadow_rays.count > 0) {
        find_visibility(world, s.shadow_rays, s.stepped_rays, s.record);
        if (first_hits != nullptr) count_tested(s.surfaces, s.light_samples, *first_hits);
        if (world.colors_shadows()) store_filters(s.shadow_rays, s.surfaces.count, s.light_samples);
        apply_shadows(s.shadow_rays, s.surfaces.count, s.light_samples);
        if (first_hits != nullptr) count_unoccluded(world, s.surfaces, s.light_samples, *first_hits);
        s.counts.shadow += static_cast<std::uint64_t>(s.shadow_rays.count);
    } else if (rules.samples_shadow) {
        if (first_hits != nullptr) count_tested(s.surfaces, s.light_samples, *first_hits);
        sample_area_shadow(world, light, s.surfaces, s.light_samples, s.area_shadow, s.shadow_rays,
                           s.stepped_rays, s.counts, s.record);
        if (first_hits != nullptr) count_visible(s.surfaces, s.light_samples, s.area_shadow, *first_hits);
    }
    compute_highlights(rules, s.surfaces, s.light_samples, s.highlights);
    add_light(world, light, rules, s.surfaces, s.light_samples, s.highlights, s.radiance);
    if (s.record != nullptr)
        record_light(world, light, rules, s.surfaces, s.light_samples, s.shadow_rays, s.area_shadow,
                     *s.record);
}

/// Adds the light of a light to the surfaces.
inline void light_surfaces(const WorldParts& world, const PreparedLight& light, TileScratch& s) {
    if (!light.is_area() || world.conventions.area_shading == AreaShading::center)
        return light_from(world, light, s);
    PreparedLight sample = light;
    const double part = 1.0 / light.area.count();
    sample.color = light.color * part;
    sample.specular_color = light.specular_color * part;
    for (int i = 0; i < light.area.count(); ++i) {
        sample.sample = i;
        if (!light.moves_samples()) sample.position = fixed_sample(world, light.area, i);
        light_from(world, sample, s);
    }
}

/// Traces rays of the light from all directions.
inline void trace_sky_rays(const WorldParts& world, TileScratch& s) {
    if (world.settings.shadows) {
        find_sky_visibility(world, s.shadow_rays, s.stepped_rays);
        s.counts.shadow += static_cast<std::uint64_t>(s.shadow_rays.count);
    } else {
        std::fill_n(s.shadow_rays.occluded.begin(), s.shadow_rays.count, std::uint8_t{0});
    }
    add_sky_rays(world, s.shadow_rays, s.sky);
    if (s.record != nullptr) record_sky_rays(s.shadow_rays, s.sky, *s.record);
}

/// Traces the rays of all samples for entries [begin, end) of the SkyBatch, at most k_batch_size.
inline void trace_sky_block(const WorldParts& world, int begin, int end, TileScratch& s) {
    const int samples = world.occlusion->samples;
    if (world.occlusion->method == OcclusionMethod::fixed) {
        const Vec3* const fixed = fixed_block(world, s.rays.generation, s.pixel_sample);
        for (int sample = 0; sample < samples; ++sample) {
            make_fixed_rays(world, fixed[sample], begin, end, s.sky, s.shadow_rays);
            trace_sky_rays(world, s);
        }
        return;
    }
    const SampleGrid grid(samples);
    for (int first = 0; first < samples; first += k_sky_group_samples) {
        make_hashed_rays(grid, first, number::min(first + k_sky_group_samples, samples), begin, end - begin,
                         s.sky, s.sky_group);
        for (int at = 0; at < s.sky_group.count; at += k_batch_size) {
            take_hashed_rays(world, s.sky_group, at, begin, s.sky, s.shadow_rays);
            trace_sky_rays(world, s);
        }
    }
}

/// Calls visit for the ranges of hits that are shaded together.
template <class Visit> inline void for_each_range(const HitBatch& hits, const Visit& visit) {
    for (int i = 0; i < hits.count; i += k_batch_size)
        visit(RayRange{i, number::min(i + k_batch_size, hits.count)});
}

/// Collects the hits of a range and computes their surfaces.
inline void find_surfaces(const WorldParts& world, RayRange range, TileScratch& s) {
    collect_hits(world, s.rays, s.hits, range, s.surfaces);
    locate_surfaces(world, s.surfaces);
    color_surfaces(world, s.surfaces);
}

/// Traces the light from all directions for the surfaces of a whole stream: more of their rays start near
/// each other than in a range.
inline void trace_sky(const WorldParts& world, TileScratch& s) {
    sort_hits(s.hits, s.sky);
    for_each_range(s.hits, [&](RayRange range) {
        find_surfaces(world, range, s);
        if (s.rays.hashed) hash_rays(s.pixel_hash, s.surfaces);
        place_surfaces(s.surfaces, s.sky);
    });
    s.sky.first = 0;
    if (s.record != nullptr) s.record->sky_rays.clear();
    for (int begin = 0; begin < s.sky.count; begin += k_batch_size)
        trace_sky_block(world, begin, number::min(begin + k_batch_size, s.sky.count), s);
}

/// Adds the light from all directions to that of the surfaces, and goes on to the surfaces of the next range.
inline void light_from_sky(const WorldParts& world, TileScratch& s) {
    if (s.surfaces.generation == 0 && s.first_hits.wanted) count_sky(world, s.surfaces, s.sky, s.first_hits);
    add_sky(world, s.surfaces, s.sky, s.radiance);
    if (s.record != nullptr) record_sky(world, s.surfaces, s.sky, s.radiance, *s.record);
    s.sky.first += s.surfaces.count;
}

/// Records the surfaces of a range of rays, and queues the secondary rays of as many generations as the
/// record has.
inline void follow(const WorldParts& world, RayRange range, TileScratch& s) {
    find_surfaces(world, range, s);
    record_surfaces(world, s.rays, s.hits, range, s.surfaces, *s.surface_record);
    if (!world.has_lighting() || static_cast<std::size_t>(s.rays.generation) + 1 >= s.surface_record->size())
        return;
    if (s.rays.hashed) hash_rays(s.pixel_hash, s.surfaces);
    apply_beer_law(world, s.surfaces);
    apply_fog(world, s.surfaces);
    queue_secondary_rays(world, s.surfaces, s.secondary, s.film, s.counts, nullptr);
}

/// Runs the stages that follow intersect() for a range of rays. Adds their light to the film, and the mirror
/// and glass rays of their surfaces to the next generation.
inline void shade(const WorldParts& world, RayRange range, TileScratch& s) {
    find_surfaces(world, range, s);
    if (s.rays.generation == 0 && s.first_hits.wanted)
        store_first_hits(world, s.rays, s.hits, range, s.surfaces, s.first_hits);
    if (!world.has_lighting()) {
        add_misses(world, s.rays, s.hits, range, s.film);
        add_unlit(world, s.surfaces, s.film);
        if (s.record != nullptr) {
            record_rays(world, s.rays, s.hits, range, s.surfaces, *s.record);
            record_unlit(world, s.surfaces, *s.record);
        }
        return;
    }
    if (s.rays.hashed) hash_rays(s.pixel_hash, s.surfaces);
    apply_beer_law(world, s.surfaces);
    apply_fog(world, s.surfaces);
    if (s.record != nullptr) record_rays(world, s.rays, s.hits, range, s.surfaces, *s.record);
    clear_radiance(s.surfaces, s.radiance);
    for (const PreparedLight& light : *world.lights) light_surfaces(world, light, s);
    if (world.occlusion) light_from_sky(world, s);
    add_to_film(world, s.rays, s.hits, range.begin, s.surfaces, s.radiance, s.film);
    if (s.record != nullptr) record_sums(world, s.surfaces, s.radiance, *s.record);
    queue_secondary_rays(world, s.surfaces, s.secondary, s.film, s.counts, s.record);
}

/// Traces one sample of each pixel: the camera rays, then the secondary rays, one generation after the other.
/// Returns false if all camera rays miss; their light has then not been added.
inline bool trace_sample(const WorldParts& world, TileScratch& s) {
    while (s.rays.count > 0) {
        s.secondary.rays.clear();
        s.secondary.rays.generation = s.rays.generation + 1;
        for (int first = 0; first < s.rays.count; first += k_stream_size) {
            intersect(world, s.rays, first, s.hits);
            if (is_of_hits(world.fault)) put_faulty_hits(world, s.rays, s.hits);
            if (s.rays.transparent || world.has_holes)
                skip_transparent(world, s.rays, s.hits, s.stepped_rays);
            if (s.rays.generation == 0 && !s.needs_every_stage() && all_missed(s.hits)) return false;
            if (s.surface_record != nullptr) {
                for_each_range(s.hits, [&](RayRange range) { follow(world, range, s); });
                continue;
            }
            if (world.occlusion && world.has_lighting()) trace_sky(world, s);
            for_each_range(s.hits, [&](RayRange range) { shade(world, range, s); });
        }
        std::swap(s.rays, s.secondary.rays);
    }
    return true;
}

inline bool is_cancelled(const TileJob& job) { return job.cancel.is_set(); }

/// Lists the pixels of a tile, in the order of their numbers.
inline void list_tile(const TileJob& job, PixelList& pixels) {
    pixels.count = 0;
    for_each_row(job, [&](int x, int y, int, int width) {
        for (int i = x; i < x + width; ++i) pixels.add(job.x + i, job.y + y);
    });
}

/// Traces n x n samples of each pixel of the tile, or of the list if there is one, into the film. Returns
/// false if n is 1 and all camera rays miss; their light has then not been added. Stops early if the render
/// is cancelled: the picture is then not used.
inline bool trace_samples(const WorldParts& world, const TileJob& job, const PixelList* list, int n,
                          TileScratch& s) {
    TileRecord* const record = s.record;
    bool added = true;
    const bool alpha =
        world.settings.alpha || (job.layers != nullptr && job.layers->of(Layer::alpha) != nullptr);
    s.film.clear(alpha);
    s.surfaces.start(world.geometry->has_elements());
    s.rays.alpha = s.secondary.rays.alpha = alpha;
    s.rays.transparent = s.secondary.rays.transparent = world.has_transparency();
    if (list == nullptr && is_jittered(world, n)) {
        list_tile(job, s.pixels);
        list = &s.pixels;
    }
    const bool hashed = needs_hashes(world);
    s.rays.hashed = s.secondary.rays.hashed = hashed;
    s.rays.tracked = s.secondary.rays.tracked = world.interiors.tracked;
    SampleIndex sample{0, 0, n};
    for (sample.j = 0; sample.j < n; ++sample.j) {
        for (sample.i = 0; sample.i < n; ++sample.i) {
            if (is_cancelled(job)) {
                s.record = record;
                return true;
            }
            if (list != nullptr) {
                make_listed_camera_rays(world, *list, sample, s.rays);
            } else {
                make_camera_rays(world, job, sample, s.rays);
            }
            if (s.rays.tracked) set_camera_interiors(world, s.rays);
            if (hashed) hash_pixels(world, job, list, sample, s.pixel_hash);
            s.counts.camera += static_cast<std::uint64_t>(s.rays.count);
            if (is_limited(world)) s.secondary.of_pixel.fill(0);
            s.first_hits.is_middle = sample.is_middle();
            s.pixel_sample = sample.number();
            if (record != nullptr) s.record = record->begin(sample.number()) ? record : nullptr;
            if (trace_sample(world, s)) continue;
            added = n > 1 || !is_background_uniform(world);
            if (added) add_misses(world, s.rays, s.hits, {0, s.hits.count}, s.film);
        }
    }
    s.record = record;
    return added;
}

/// Renders a tile with n x n samples for each pixel. Returns false if all is background, and the film has
/// not been used.
inline bool render_uniform_tile(const WorldParts& world, const TileJob& job, int n, TileScratch& s) {
    const bool layers = job.layers != nullptr;
    s.first_hits.wanted = layers;
    if (layers) clear_first_hits(s.first_hits);
    if (!s.needs_every_stage() && is_background_uniform(world) && is_tile_empty(world, job)) {
        s.counts.camera += static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n) *
                           static_cast<std::uint64_t>(job.width * job.height);
        fill_background(world, job, n);
        return false;
    }
    if (!trace_samples(world, job, nullptr, n, s)) {
        fill_background(world, job, n);
        return false;
    }
    if (is_cancelled(job)) return true;
    resolve(job, s.film, n);
    if (layers) write_layers(job, s.film, s.first_hits, n);
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
