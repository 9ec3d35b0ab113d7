// SPDX-License-Identifier: Apache-2.0
// The stage that lets rays pass holes, and surfaces beyond the limit of shaded transparent ones; only scenes
// with holes (is_hole()) or transparent surfaces have it.
#if defined(GLINT_TRACE_SKIP_TRANSPARENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SKIP_TRANSPARENT_INL_H_
#undef GLINT_TRACE_SKIP_TRANSPARENT_INL_H_
#else
#define GLINT_TRACE_SKIP_TRANSPARENT_INL_H_
#endif

#include "trace/hits/intersect-inl.h"
#include "world/appearance/appearance.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Lets the rays of a stream go on behind holes, and those that have passed as many
/// transparent surfaces as the conventions shade to the next surface that is not transparent. A surface that
/// is passed in the second way is of the next generation if transparency counts; a ray beyond the limit of
/// generations then hits nothing with LimitRule::background.
inline void skip_transparent(const WorldParts& world, RayBatch& rays, HitBatch& hits, SteppedRays& steps) {
    const Conventions& rules = world.conventions;
    const bool camera = rays.generation == 0;
    const bool limited = rays.transparent && rules.transparent_surfaces < k_max_sample_rays &&
                         !(camera && rules.transparent_surfaces > 0);
    if (!limited && !world.has_holes) return;
    const RaySpan span = rays.span(hits.first);
    const auto is_beyond = [&](int i) {
        return limited && (camera || rays.passed[static_cast<std::size_t>(hits.first + i)] >=
                                         static_cast<double>(rules.transparent_surfaces));
    };
    const auto skips = [&](int i, SurfaceId id) {
        return is_beyond(i) && world.is_transparent(material_row(world, id));
    };
    const auto is_hole_at = [&](int i, double t, SurfaceId id) {
        const Vec3 direction{span.dx[i], span.dy[i], span.dz[i]};
        return is_hole(world, id, Vec3{span.ox[i], span.oy[i], span.oz[i]} + direction * t, direction);
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
            if (!id.exists()) return false;
            if (is_hole_at(i, t, id)) return true;
            if (!skips(i, id)) return false;
            if (!end_ray(i)) return true;
            hits.columns().set(i, span.t_max[i], {});
            return false;
        };
        for (int i = first; i < end; ++i) {
            if (!world.has_holes && !is_beyond(i)) continue;
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
