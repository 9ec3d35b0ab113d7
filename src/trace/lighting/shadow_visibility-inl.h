// SPDX-License-Identifier: Apache-2.0
// The stages that find what shadow rays meet: occluders, and transparent surfaces that color the light.
#if defined(GLINT_TRACE_SHADOW_VISIBILITY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SHADOW_VISIBILITY_INL_H_
#undef GLINT_TRACE_SHADOW_VISIBILITY_INL_H_
#else
#define GLINT_TRACE_SHADOW_VISIBILITY_INL_H_
#endif

#include <algorithm>
#include <bit>

#include "trace/hits/intersect-inl.h"
#include "trace/record.h"
#include "world/appearance/appearance.h"
#include "world/appearance/fade.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Multiplies the light of a shadow ray by what an object leaves of it where it goes out, towards the light,
/// through the surface at t. along: the way in the object before that, in units of t.
GLINT_SMALL void fade_light(const WorldParts& world, ShadowRayBatch& rays, int ray, SurfaceId id, double t,
                            double along, TileRecord* record) {
    if (!(world.extended_row(material_row(world, id))[k_extended_value<&Material::fade_power>] > 0)) return;
    const Vec3 direction = vec3_at(rays.direction, ray), point = vec3_at(rays.origin, ray) + direction * t;
    const Color fade =
        fade_at(world, id, point, rays.from_light ? -direction : direction, along * glint::length(direction));
    const double factors[] = {fade.r, fade.g, fade.b};
    for (std::size_t c = 0; c < 3; ++c) rays.filter[c][ray] *= factors[c];
    if (record == nullptr) return;
    const auto is_of_ray = [&](const TileRecord::ShadowStep& step) { return step.ray == ray; };
    std::find_if(record->shadow_steps.rbegin(), record->shadow_steps.rend(), is_of_ray)->fade = fade;
}

/// Computes the factors of the light of shadow rays that are not occluded: the product over the transparent
/// surfaces on the way, in the order of t. Surfaces at equal t count once, the first in the scene; those
/// within Conventions::transparent_shadow_epsilon behind it, or of the surface that is lit, do not count.
/// Where materials fade, each factor is followed by what the object leaves. caustics: whether materials that
/// have some concentrate the light.
GLINT_SMALL void filter_light(const WorldParts& world, ShadowRayBatch& rays, SteppedRays& steps,
                              bool caustics, TileRecord* record) {
    for (auto& column : rays.filter) std::fill_n(column.begin(), rays.count, 1.0);
    steps.count = 0;
    const RaySpan span = rays.span();
    const bool fades = world.uses<&Material::fade_distance>();
    const double gap = world.conventions.transparent_shadow_epsilon;
    const double start_gap = gap - world.conventions.epsilon;  // the rays begin at epsilon
    for (int i = 0; i < rays.count; ++i) {
        if (rays.occluded[static_cast<std::size_t>(i)] == 0) {
            steps.add(span, i, span.t_min[i]);
            if (start_gap > 0)
                steps.leave_out(start_gap / glint::length(steps.direction_of(steps.count - 1)),
                                rays.from_light);
        }
        if (fades)
            steps.passed[static_cast<std::size_t>(i)] = {}, steps.t_passed[static_cast<std::size_t>(i)] = 0;
    }
    const auto fade_last = [&](std::size_t i, double t) {
        if (rays.from_light && steps.passed[i].exists())
            fade_light(world, rays, static_cast<int>(i), steps.passed[i], steps.t_passed[i],
                       t - steps.t_passed[i], record);
    };
    for (int step = 0; steps.count > 0 && step < k_max_steps; ++step) {
        intersect_steps(world, steps);
        int left = 0;
        for (int k = 0; k < steps.count; ++k) {
            const auto at = static_cast<std::size_t>(k);
            const SurfaceId id = steps.surface(k);
            if (!id.exists()) continue;
            const auto i = static_cast<std::size_t>(steps.number[at]);
            if (colors_light(world, id)) {
                if (fades) fade_last(i, steps.t[at]);
                Color factor = shadow_factor(world, id, steps.point_of(k));
                if (caustics)
                    factor = factor * caustics_at(world, id, steps.point_of(k), steps.direction_of(k));
                const double factors[] = {factor.r, factor.g, factor.b};
                double most = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    rays.filter[c][i] *= factors[c];
                    most = number::max(most, rays.filter[c][i]);
                }
                if (record != nullptr)
                    record->shadow_steps.push_back({steps.number[at], id, steps.t[at], factor, {1, 1, 1}});
                if (fades) {
                    if (!rays.from_light)
                        fade_light(world, rays, steps.number[at], id, steps.t[at],
                                   steps.t[at] - steps.t_passed[i], record);
                    steps.passed[i] = id;
                    steps.t_passed[i] = steps.t[at];
                }
                if (most < k_min_filter) {
                    rays.occluded[i] = 1;
                    continue;
                }
            }
            steps.go_on(k, left++, gap > 0 ? gap / glint::length(steps.direction_of(k)) : 0);
        }
        steps.count = left;
    }
    if (!fades) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
        fade_last(i, 1);
        const double most = number::max(number::max(rays.filter[0][i], rays.filter[1][i]), rays.filter[2][i]);
        if (most < k_min_filter) rays.occluded[i] = 1;
    }
}

/// Determines which shadow rays are occluded, and with colored shadows the factor of the light of the others
/// (ShadowRayBatch::filter).
inline void find_visibility(const WorldParts& world, ShadowRayBatch& rays, SteppedRays& steps,
                            TileRecord* record) {
    intersect_shadow(world, rays);
    if (world.colors_shadows()) filter_light(world, rays, steps, world.uses<&Material::caustics>(), record);
}

/// Stores the factors of the shadow rays by surface. Before apply_shadows().
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

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
