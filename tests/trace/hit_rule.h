// SPDX-License-Identifier: Apache-2.0
#pragma once
// The hit rule without lanes, packets or a hierarchy. The kernels must give the same bits.
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/kinds-inl.h"
#include "trace/rays.h"
#include "world/primitive_box.h"
#include "world/world.h"

namespace glint::test {

namespace plain = HWY_NAMESPACE;

inline float rounded_down(double x) {
    const auto f = static_cast<float>(x);
    return f - (std::fabs(f) * 0x1p-23f + 1e-37f);
}
inline float rounded_up(double x) { return -rounded_down(-x); }

struct Interval {
    float entry, exit;
};

/// The interval of t in which the ray is inside a slot's padded box.
inline Interval box_interval(const PackedGeometry& geometry, std::uint32_t slot, Vec3 o, Vec3 d) {
    const double origin[3] = {o.x, o.y, o.z}, direction[3] = {d.x, d.y, d.z};
    const Aabb box = primitive_box(geometry, slot);
    Interval in{-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    for (int a = 0; a < 3; ++a) {
        auto along = static_cast<float>(direction[a]);
        if (std::fabs(along) < 1e-30f) along = along < 0 ? -1e-30f : 1e-30f;
        const float lo = box.lo[a], hi = box.hi[a];
        const float inverse = 1 / along;
        const float below = rounded_down(origin[a]), above = rounded_up(origin[a]);
        const float to_near = along > 0 ? lo - above : hi - below,
                    to_far = along > 0 ? hi - below : lo - above;
        const float entry = to_near * (inverse * (1 - 0x1p-21f)), exit = to_far * (inverse * (1 + 0x1p-21f));
        if (entry > in.entry) in.entry = entry;
        if (exit < in.exit) in.exit = exit;
    }
    return in;
}

struct FormulaHit {
    const ShapeClass& shapes;
    std::uint32_t item;
    plain::Ray<double> ray;
    double t_min;
    plain::Hit<double> hit{};
    template <class Geometry> void visit() {
        double p[Geometry::k_values];
        for (int k = 0; k < Geometry::k_values; ++k) p[k] = shapes.column(k)[item];
        if constexpr (Geometry::k_has_formula && !Geometry::k_only_operand)
            hit = Geometry::hit(p, ray, t_min);
    }
};

struct BruteHit {
    double t;
    std::uint32_t slot;
};

inline BruteHit brute_nearest(const World& world, Vec3 o, Vec3 d, double t_min, double t_max) {
    const PackedGeometry& geometry = *world.parts().geometry;
    BruteHit best{t_max, k_none};
    for (const ShapeClass& shapes : geometry.classes) {
        for (std::uint32_t item = 0; item < shapes.count; ++item) {
            const std::uint32_t slot = shapes.first + item;
            Interval in{-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
            if (slot < geometry.bounded) in = box_interval(geometry, slot, o, d);
            if (!(in.entry <= in.exit)) continue;
            FormulaHit formula{shapes, item, {{o.x, o.y, o.z}, {d.x, d.y, d.z}}, t_min};
            plain::visit_geometry(shapes.kind, shapes.transformed, formula);
            if (!formula.hit.valid) continue;
            double t = formula.hit.t;
            if (t < in.entry) t = in.entry;
            if (t > in.exit) t = in.exit;
            if (!(t > t_min && t < t_max)) continue;
            // Ties within a polygon go to the triangle that was cut off first.
            const auto order = [&](std::uint32_t s) {
                return std::pair(geometry.shape_index[s], geometry.element_of(s));
            };
            if (t < best.t || (t == best.t && order(slot) < order(best.slot))) best = {t, slot};
        }
    }
    return best;
}

inline Hits brute_hits(const World& world, const Rays& rays) {
    Hits hits;
    for (int i = 0; i < rays.size(); ++i) {
        const BruteHit h =
            brute_nearest(world, rays.origin(i), rays.direction(i), rays.t_min(i), rays.t_max(i));
        hits.t.push_back(h.t);
        hits.slot.push_back(h.slot);
        hits.element.push_back(h.slot == k_none ? 0 : world.parts().geometry->element_of(h.slot));
    }
    return hits;
}

}  // namespace glint::test
