// SPDX-License-Identifier: Apache-2.0
// The stages that only scenes with transparent surfaces (Material::filter, transmit) have: rays that pass
// surfaces beyond the limit of shaded ones, and shadow rays whose light the surfaces on their way color.
#if defined(GLINT_TRACE_TRANSPARENCY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_TRANSPARENCY_INL_H_
#undef GLINT_TRACE_TRANSPARENCY_INL_H_
#else
#define GLINT_TRACE_TRANSPARENCY_INL_H_
#endif

#include "trace/intersect-inl.h"
#include "trace/record.h"
#include "world/appearance.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// A light whose factor is below this in every channel counts as blocked.
inline constexpr double k_min_filter = 0x1p-10;
/// The surfaces along a ray that are counted or skipped, at most.
inline constexpr int k_max_steps = 4096;

/// Finds the nearest hits of the stepped rays.
inline void intersect_steps(const WorldParts& world, SteppedRays& steps) {
    nearest_hit(world, steps.span(), steps.count, k_packet_size, steps.hits());
}

/// Computes the factors of the light of shadow rays that are not occluded: the product over the transparent
/// surfaces on the way, in the order of t. Surfaces at equal t count once, the first in the scene; those
/// within Conventions::transparent_shadow_epsilon behind it do not count.
inline void filter_light(const WorldParts& world, ShadowRayBatch& rays, SteppedRays& steps,
                         TileRecord* record) {
    for (auto& column : rays.filter) std::fill_n(column.begin(), rays.count, 1.0);
    steps.count = 0;
    const RaySpan span = rays.span();
    for (int i = 0; i < rays.count; ++i) {
        if (rays.occluded[static_cast<std::size_t>(i)] == 0) steps.add(span, i, span.t_min[i]);
    }
    for (int step = 0; steps.count > 0 && step < k_max_steps; ++step) {
        intersect_steps(world, steps);
        int left = 0;
        for (int k = 0; k < steps.count; ++k) {
            const auto at = static_cast<std::size_t>(k);
            const SurfaceId id = steps.surface(k);
            if (!id.exists()) continue;
            const auto i = static_cast<std::size_t>(steps.number[at]);
            if (colors_light(world, id)) {
                const Color factor = shadow_factor(world, id);
                const double factors[] = {factor.r, factor.g, factor.b};
                double most = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    rays.filter[c][i] *= factors[c];
                    most = number::max(most, rays.filter[c][i]);
                }
                if (record != nullptr) record->shadow_steps.push_back({steps.number[at], id, steps.t[at]});
                if (most < k_min_filter) {
                    rays.occluded[i] = 1;
                    continue;
                }
            }
            const double gap = world.conventions.transparent_shadow_epsilon;
            steps.go_on(k, left++, gap > 0 ? gap / glint::length(steps.direction_of(k)) : 0);
        }
        steps.count = left;
    }
}

/// Determines which shadow rays are occluded, and with colored shadows the factor of the light of the others
/// (ShadowRayBatch::filter).
inline void find_visibility(const WorldParts& world, ShadowRayBatch& rays, SteppedRays& steps,
                            TileRecord* record) {
    intersect_shadow(world, rays);
    if (world.colors_shadows()) filter_light(world, rays, steps, record);
}

/// Stores the factors of the shadow rays by surface. Before apply_occlusion().
inline void store_filters(const ShadowRayBatch& rays, int surfaces, LightSampleBatch& samples) {
    int first = 0;
    for (int i = 0; i < surfaces; i += lane_count<double>()) {
        const std::uint8_t bits = samples.lit[static_cast<std::size_t>(i / lane_count<double>())];
        if (bits == 0) continue;
        const auto lit = from_bits<double>(bits);
        for (std::size_t c = 0; c < 3; ++c)
            store(expand_load(rays.filter[c].data() + first, lit), samples.filter[c].data() + i);
        first += std::popcount(bits);
    }
}

/// Lets the rays of a stream that have passed as many transparent surfaces as the conventions shade go on to
/// the next surface that is not transparent. A surface that is passed in this way is of the next generation
/// if transparency counts; a ray beyond the limit of generations then hits nothing with
/// LimitRule::background.
inline void skip_transparent(const WorldParts& world, RayBatch& rays, HitBatch& hits, SteppedRays& steps) {
    const Conventions& rules = world.conventions;
    if (rules.transparent_surfaces >= k_max_sample_rays) return;
    const bool camera = rays.generation == 0;
    if (camera && rules.transparent_surfaces > 0) return;
    const RaySpan span = rays.span(hits.first);
    const auto skips = [&](SurfaceId id) {
        return id.exists() && world.is_transparent(material_row(world, id));
    };
    // Counts a generation. Returns whether the ray ends.
    const auto end_ray = [&](int i) {
        if (camera || !rules.transparency_counts || rules.limit != LimitRule::background) return false;
        double& level = rays.level[static_cast<std::size_t>(hits.first + i)];
        if (level >= world.settings.reflections) return true;
        level += 1;
        return false;
    };
    for (int first = 0; first < hits.count; first += k_batch_size) {
        steps.count = 0;
        const int end = number::min(first + k_batch_size, hits.count);
        const auto go_on_behind = [&](int i, double t, SurfaceId id) {
            hits.columns().set(i, t, id);
            if (!skips(id)) return false;
            if (!end_ray(i)) return true;
            hits.columns().set(i, span.t_max[i], {});
            return false;
        };
        for (int i = first; i < end; ++i) {
            if (!camera && rays.passed[static_cast<std::size_t>(hits.first + i)] < rules.transparent_surfaces)
                continue;
            const double t = hits.t[static_cast<std::size_t>(i)];
            if (go_on_behind(i, t, hits.surface(i))) steps.add(span, i, t);
        }
        for (int step = 0; steps.count > 0 && step < k_max_steps; ++step) {
            intersect_steps(world, steps);
            int left = 0;
            for (int k = 0; k < steps.count; ++k) {
                const auto at = static_cast<std::size_t>(k);
                if (go_on_behind(steps.number[at], steps.t[at], steps.surface(k))) steps.go_on(k, left++);
            }
            steps.count = left;
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
