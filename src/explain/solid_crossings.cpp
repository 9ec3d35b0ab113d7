// SPDX-License-Identifier: Apache-2.0
// The kernels do not record crossings, so that they lose no time: they are found again, by the same kernels.
#include "explain/solid_crossings.h"

#include <algorithm>

#include "base/sort_stably.h"
#include "trace/hits/solid_states-inl.h"

namespace glint {
namespace {

using HWY_NAMESPACE::k_event_error, HWY_NAMESPACE::k_event_size;

double largest(Vec3 v) {
    return number::max(number::abs(v.x), number::max(number::abs(v.y), number::abs(v.z)));
}

std::uint32_t solid_slot(const PackedGeometry& geometry, std::uint32_t shape) {
    for (const ShapeClass& shapes : geometry.classes) {
        if (shapes.kind != ShapeKind::solid) continue;
        for (std::uint32_t slot = shapes.first; slot < shapes.first + shapes.count; ++slot)
            if (geometry.shape_index[slot] == shape) return slot;
    }
    return k_none;
}

// By operand: whether the line is inside beyond t.
std::vector<std::uint32_t> states_at(const std::vector<std::vector<double>>& intervals, double t) {
    std::vector<std::uint32_t> states;
    for (const std::vector<double>& of : intervals) {
        std::uint32_t inside = 0;
        for (std::size_t k = 0; k < of.size(); k += 2) inside |= of[k] <= t && of[k + 1] > t ? 1u : 0u;
        states.push_back(inside);
    }
    return states;
}

void find_crossings_of(const PackedGeometry& geometry, const Kernels& kernels, ExplainedRay& ray) {
    ExplainedHit& hit = *ray.hit;
    const std::uint32_t slot = solid_slot(geometry, hit.shape);
    if (slot == k_none) return;
    const PackedSolid& solid =
        geometry.solids[static_cast<std::size_t>(geometry.class_of(slot).value(0, slot))];
    std::vector<std::vector<double>> intervals;
    std::vector<double> ends;
    std::vector<ExplainedCrossing> all;
    for (std::size_t operand = 0; operand < solid.slots.size(); ++operand) {
        kernels.operand_intervals(geometry, solid.slots[operand], ray.origin, ray.direction, ends);
        std::vector<double>& own = intervals.emplace_back();
        for (std::size_t k = 0; k < ends.size(); k += 2) {
            if (!(ends[k] < ends[k + 1])) continue;
            for (std::size_t end = 0; end < 2; ++end) {
                own.push_back(ends[k + end]);
                if (number::abs(own.back()) < number::k_infinity)
                    all.push_back({static_cast<int>(operand), own.back(), end == 0, false, false});
            }
        }
    }
    sort_stably(all, [](const auto& a, const auto& b) { return a.t < b.t; });
    const double error = largest(ray.origin) * k_event_error, size = largest(ray.direction);
    bool is_found = false;
    std::vector<std::uint32_t> before = states_at(intervals, -number::k_infinity);
    for (std::size_t i = 0; i < all.size();) {
        const double t = all[i].t;
        const double last = t + (largest(ray.origin + ray.direction * t) * k_event_size + error) / size;
        const std::vector<std::uint32_t> after = states_at(intervals, last);
        if ((HWY_NAMESPACE::find_surface(solid.items, before.data(), after.data()) & 1) != 0) {
            const std::size_t face =
                HWY_NAMESPACE::find_face(solid.items, before.data(), after.data(), after.size(), 1);
            for (std::size_t k = i; k < all.size() && all[k].t <= last; ++k) {
                if (static_cast<std::size_t>(all[k].operand) != face) continue;
                all[k].surface = true;
                all[k].hit = !is_found && t > ray.t_min && face == hit.element;
                break;
            }
            is_found = is_found || t > ray.t_min;
        }
        while (i < all.size() && all[i].t <= last) ++i;
        before = after;
    }
    // Rounding at the edge of a shape's box can let the kernels pass what is listed: then nothing is.
    const auto is_hit = [](const ExplainedCrossing& crossing) { return crossing.hit; };
    if (all.size() <= k_max_explained_crossings && std::any_of(all.begin(), all.end(), is_hit))
        hit.crossings = std::move(all);
}

}  // namespace

void find_solid_crossings(const Scene& scene, const WorldParts& world, const Kernels& kernels,
                          Explanation& explanation) {
    if (scene.solids.empty()) return;
    for (ExplainedRay& ray : explanation.rays) {
        // Quadrics and quartics by themselves are packed as solids, too.
        if (ray.hit && scene.shapes[ray.hit->shape].kind == ShapeKind::solid)
            find_crossings_of(*world.geometry, kernels, ray);
    }
}

}  // namespace glint
