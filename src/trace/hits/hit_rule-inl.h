// SPDX-License-Identifier: Apache-2.0
// Intersection of rays with shapes. This file defines the hit rule:
//   A ray hits a shape at t if the shape's formula finds an intersection and the ray intersects the shape's
//   padded bounds according to the slab expression of the hierarchy. t is clamped to the interval of the
//   bounds and must be in (t_min, t_max). The nearest hit is the one with the least (t, shape, element).
// The rule does not depend on the grouping of rays into packets or on the tree.
#if defined(GLINT_TRACE_HIT_RULE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_HIT_RULE_INL_H_
#undef GLINT_TRACE_HIT_RULE_INL_H_
#else
#define GLINT_TRACE_HIT_RULE_INL_H_
#endif

#include "trace/hits/hit_result-inl.h"
#include "trace/hits/packet_filters-inl.h"
#include "trace/hits/sheared_rays-inl.h"
#include "world/geometry/primitive_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Tests shapes against a packet, or against one ray, of a chunk of rays.
struct ShapeTests {
    const PackedGeometry& geometry;
    const RaySpan& rays;  // of the chunk
    SlabRays& slab_rays;
    const HitResult& result;
    ShearedRays& sheared_rays;
    QuickRays& quick_rays;
    std::uint32_t instance = k_none;  // the slot of the shape whose mesh `geometry` is; k_none: none

    HWY_INLINE SurfaceId surface_of(std::uint32_t slot) const {
        return instance == k_none ? geometry.surface_of(slot) : SurfaceId{instance, geometry.element[slot]};
    }

    HWY_INLINE Ray<Doubles> ray_lanes(int i) const {
        return {{load(rays.ox + i), load(rays.oy + i), load(rays.oz + i)},
                {load(rays.dx + i), load(rays.dy + i), load(rays.dz + i)}};
    }
    HWY_INLINE Ray<Doubles> one_ray(int i) const {
        return {{Doubles(rays.ox[i]), Doubles(rays.oy[i]), Doubles(rays.oz[i])},
                {Doubles(rays.dx[i]), Doubles(rays.dy[i]), Doubles(rays.dz[i])}};
    }

    Vec3 origin(const RayPacket& b) const { return {rays.ox[b.first], rays.oy[b.first], rays.oz[b.first]}; }

    /// Tests a leaf: slots [first, first + count), of one class.
    HWY_INLINE void visit(RayPacket& packet, std::uint64_t active, std::uint32_t first, std::uint32_t count) {
        with_bounded(first, [&]<class Geometry>(Kind<Geometry>, const ShapeClass& shapes) HWY_ATTR {
            if constexpr (!Geometry::k_has_formula)
                parts_leaf<Geometry>(shapes, packet, active, first, count);
            else
                packet_leaf<Geometry>(shapes, packet, active, first, count);
        });
        packet.update_t_max();
    }
    /// The same for few rays of the packet, of which each tests a vector of shapes at a time; any_hit only.
    HWY_INLINE void visit_rays(const RayPacket& packet, std::uint64_t active, std::uint32_t first,
                               std::uint32_t count) {
        with_bounded(first, [&]<class Geometry>(Kind<Geometry>, const ShapeClass& shapes) HWY_ATTR {
            if constexpr (!Geometry::k_has_formula)
                parts_leaf<Geometry>(shapes, packet, active, first, count);
            else
                rays_leaf<Geometry>(shapes, first, count, packet.first, active);
        });
    }
    HWY_INLINE void visit(int ray, std::uint32_t first, std::uint32_t count) {
        with_bounded(first, [&]<class Geometry>(Kind<Geometry>, const ShapeClass& shapes) HWY_ATTR {
            if constexpr (!Geometry::k_has_formula)
                parts_leaf<Geometry>(shapes, RayPacket(slab_rays, ray, 1), 1, first, count);
            else
                ray_leaf<Geometry>(shapes, first, count, ray);
        });
    }
    /// Tests one shape with the packet.
    HWY_INLINE void visit_shape(const RayPacket& packet, std::uint32_t slot) {
        with_bounded(slot, [&]<class Geometry>(Kind<Geometry>, const ShapeClass& shapes) HWY_ATTR {
            if constexpr (!Geometry::k_has_formula)
                parts_leaf<Geometry>(shapes, packet, packet.unfinished(), slot, 1);
            else
                packet_leaf<Geometry>(shapes, packet, packet.unfinished(), slot, 1);
        });
    }
    /// Tests all shapes of an unbounded class with rays [0, count) of the chunk. These shapes have no bounds.
    HWY_INLINE void visit_unbounded(const ShapeClass& shapes, int count) {
        with_kind(shapes, [&]<class Geometry>(Kind<Geometry>) HWY_ATTR {
            if constexpr (!Geometry::k_bounded && !Geometry::k_only_operand) {
                for (std::uint32_t s = shapes.first; s < shapes.first + shapes.count; ++s)
                    many_rays_unbounded<Geometry>(shapes, s, count);
            }
        });
    }

    template <class Geometry> struct Kind {};
    template <class Function> struct KindVisitor {
        const Function& function;
        template <class Geometry> HWY_INLINE void visit() { function(Kind<Geometry>()); }
    };
    /// Calls function(Kind<Geometry>()) for the geometry of a class.
    template <class Function>
    static HWY_INLINE void with_kind(const ShapeClass& shapes, const Function& function) {
        visit_geometry(shapes.kind, shapes.transformed, KindVisitor<Function>{function});
    }
    /// Calls function(Kind<Geometry>(), shapes) for the class of a slot, which has bounds.
    template <class Function> HWY_INLINE void with_bounded(std::uint32_t slot, const Function& function) {
        const ShapeClass& shapes = geometry.class_of(slot);
        with_kind(shapes, [&]<class Geometry>(Kind<Geometry> kind) HWY_ATTR {
            if constexpr (Geometry::k_bounded) function(kind, shapes);
        });
    }

    /// The shape's formula for a vector of rays.
    template <class Geometry> HWY_INLINE Hit<Doubles> formula(const Doubles* p, int i, Doubles t_min) {
        if constexpr (Geometry::k_sheared) {
            const auto sheared = sheared_rays.lanes(i);
            const int axis = sheared_rays.common_axis(i);
            if (axis >= 0) {
                const typename Geometry::template UniformPermutation<Doubles> permute{axis};
                return Geometry::hit_sheared(p, sheared, ray_lanes(i).direction, permute, t_min);
            }
        }
        return Geometry::hit(p, ray_lanes(i), t_min);
    }
    /// The shape's formula for one ray and a vector of shapes.
    template <class Geometry> HWY_INLINE Hit<Doubles> formula_of_ray(const Doubles* p, int i, Doubles t_min) {
        if constexpr (Geometry::k_sheared) {
            const auto sheared = sheared_rays.one(i);
            const typename Geometry::template UniformPermutation<Doubles> permute{sheared_rays.axis(i)};
            return Geometry::hit_sheared(p, sheared, one_ray(i).direction, permute, t_min);
        } else {
            return Geometry::hit(p, one_ray(i), t_min);
        }
    }

    /// Tests one shape with rays [i, i + lanes). bits: the rays that may hit; entry, exit: their intervals of
    /// t within the bounds.
    template <class Geometry>
    HWY_INLINE void test_rays(const Doubles* p, std::uint32_t slot, int i, std::uint32_t bits, Doubles entry,
                              Doubles exit) {
        const Doubles t_min = load(rays.t_min + i);
        const auto hit = formula<Geometry>(p, i, t_min);
        const Doubles t = min(max(hit.t, entry), exit);
        bits &= to_bits(hit.valid && t > t_min && t <= load(result.nearest.t + i));
        if (bits == 0) return;
        const SurfaceId id = surface_of(slot);
        if (result.occluded == nullptr) {
            // Store all nearer hits at once.
            const Doubles best = load(result.nearest.t + i);
            const auto nearer = t < best && from_bits<double>(bits);
            store(select(nearer, t, best), result.nearest.t + i);
            alignas(64) float t_max[lane_count<float>()] = {};
            store_narrow(t, t_max);
            const std::uint32_t done = to_bits(nearer);
            store(select(from_bits<float>(done), floats_above(load(t_max)), load(slab_rays.t_max + i)),
                  slab_rays.t_max + i);
            store_where(done, id.slot, result.nearest.slot + i);
            store_where(done, id.element, result.nearest.element + i);
            bits &= ~done;
            if (bits == 0) return;
        }
        alignas(64) double lanes[lane_count<double>()];
        store(t, lanes);
        for (; bits != 0; bits &= bits - 1) {
            const int lane = __builtin_ctz(bits);
            result.accept(i + lane, lanes[lane], id);
        }
    }

    /// Tests shapes that consist of others with the packet's rays `active`.
    template <class Geometry>
    HWY_INLINE void parts_leaf(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                               std::uint32_t first, std::uint32_t count) {
        if constexpr (Geometry::k_is_solid)
            solids_leaf(shapes, packet, active, first, count);
        else
            instances_leaf(shapes, packet, active, first, count);
    }
    /// See trace/hits/instances-inl.h.
    HWY_NOINLINE void instances_leaf(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                                     std::uint32_t first, std::uint32_t count);
    /// See trace/hits/solids-inl.h; in an object of its own, solids.cpp.
    HWY_NOINLINE void solids_leaf(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                                  std::uint32_t first, std::uint32_t count);

    template <class Geometry>
    HWY_NOINLINE void packet_leaf(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                                  std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t s = 0; s < count; s += lane_count<float>()) {
            const int n = number::min(static_cast<int>(count - s), lane_count<float>());
            const PrimitiveBounds<Geometry> boxes(geometry, shapes, first + s, n);
            std::uint32_t bits = meets(packet, packet_slab(packet, boxes.lo, boxes.hi)) & first_bits(n);
            if (bits == 0) continue;
            SharedFilters<Geometry> filters;
            if constexpr (Geometry::k_shares_filter) {
                if (packet.common_origin)
                    bits &= filters.prepare(shapes, packet, origin(packet), first + s, n);
            }
            if constexpr (Geometry::k_quick) {
                if (quick_rays.parallel()) filters.prepare(shapes, quick_rays, first + s, n);
            }
            for (; bits != 0; bits &= bits - 1)
                packet_shape<Geometry>(shapes, packet, active, boxes, filters, first + s,
                                       __builtin_ctz(bits));
        }
    }

    /// Tests the shape in slot first + lane with the packet's rays `active`.
    template <class Geometry>
    HWY_INLINE void packet_shape(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                                 const PrimitiveBounds<Geometry>& boxes,
                                 const SharedFilters<Geometry>& filters, std::uint32_t first, int lane) {
        const std::uint32_t slot = first + static_cast<std::uint32_t>(lane);
        const float lo[3] = {boxes.lo[0][lane], boxes.lo[1][lane], boxes.lo[2][lane]};
        const float hi[3] = {boxes.hi[0][lane], boxes.hi[1][lane], boxes.hi[2][lane]};
        constexpr int lanes = lane_count<float>();
        if constexpr (Geometry::k_filtered) {
            const FilteredRays filtered =
                filter_rays(shapes, packet, quick_rays, active, filters, slot, lane);
            for (std::uint64_t hit = filtered.hit; hit != 0; hit &= hit - 1)
                result.occlude(packet.first + __builtin_ctzll(hit), surface_of(slot));
            active = filtered.may_hit;
            if (active == 0) return;
        }
        Doubles p[Geometry::k_values];
        bool loaded = false;
        for (int r = 0; r < packet.count; r += lanes) {
            std::uint32_t bits = static_cast<std::uint32_t>(active >> r) & first_bits(lanes);
            if (bits == 0) continue;
            const int i = packet.first + r;
            const Slab slab = box_slab(packet, i, lo, hi);
            bits &= to_bits(meets(slab_rays, i, slab));
            if (bits == 0) continue;
            if (!loaded) broadcast_values<Geometry::k_values>(shapes, slot, p);
            loaded = true;
            alignas(64) float entry[lanes], exit[lanes];
            store(slab.entry, entry);
            store(slab.exit, exit);
            for (int c = 0; c < lanes; c += lane_count<double>()) {
                const std::uint32_t lanes_here = bits >> c & first_bits(lane_count<double>());
                if (lanes_here != 0)
                    test_rays<Geometry>(p, slot, i + c, lanes_here, widen(entry + c), widen(exit + c));
            }
        }
    }

    template <class Geometry>
    HWY_NOINLINE void many_rays_unbounded(const ShapeClass& shapes, std::uint32_t slot, int count) {
        Doubles p[Geometry::k_values];
        broadcast_values<Geometry::k_values>(shapes, slot, p);
        const Doubles infinity(std::numeric_limits<double>::infinity());
        for (int i = 0; i < count; i += lane_count<double>()) {
            const std::uint32_t bits = first_bits(number::min(count - i, lane_count<double>()));
            test_rays<Geometry>(p, slot, i, bits, -infinity, infinity);
        }
    }

    /// The result of the slab expression for one ray and a vector of primitive bounds.
    struct RaySlab {
        std::uint32_t meets;
        alignas(64) float entry[lane_count<float>()], exit[lane_count<float>()];
    };
    template <class Geometry>
    HWY_INLINE void meet_boxes(const ShapeClass& shapes, std::uint32_t first, int i, RaySlab& to) const {
        const SlabRay ray(slab_rays, i);
        const PrimitiveBounds<Geometry> boxes(geometry, shapes, first, lane_count<double>());
        const float *near[3], *far[3];
        for (int a = 0; a < 3; ++a) {
            near[a] = ray.ahead[a] ? boxes.lo[a] : boxes.hi[a];
            far[a] = ray.ahead[a] ? boxes.hi[a] : boxes.lo[a];
        }
        const Slab slab = ray.meet(near, far);
        to.meets = to_bits(meets(slab, Floats(slab_rays.t_min[i]), Floats(slab_rays.t_max[i])));
        store(slab.entry, to.entry);
        store(slab.exit, to.exit);
    }

    /// Up to a vector of a leaf's shapes, the first in `slot`: their values, and a bit for each.
    template <class Geometry> struct ShapeLanes {
        Doubles p[Geometry::k_values];
        std::uint32_t slot, bits;
        HWY_INLINE ShapeLanes(const ShapeClass& shapes, std::uint32_t first, std::uint32_t count)
            : slot(first), bits(first_bits(number::min(static_cast<int>(count), lane_count<double>()))) {
            load_values<Geometry::k_values>(shapes, slot, p);
        }
        SurfaceId surface(const ShapeTests& tests, int lane) const {
            return tests.surface_of(slot + static_cast<std::uint32_t>(lane));
        }
    };

    /// Tests one ray with a vector of shapes at a time.
    template <class Geometry>
    HWY_NOINLINE void ray_leaf(const ShapeClass& shapes, std::uint32_t first, std::uint32_t count, int i) {
        for (std::uint32_t s = 0; s < count; s += lane_count<double>()) {
            const ShapeLanes<Geometry> some(shapes, first + s, count - s);
            test_shapes(shapes, some, some.bits, i);
        }
    }

    /// The same for rays first_ray + r, for the bits r of active, until they hit.
    template <class Geometry>
    HWY_NOINLINE void rays_leaf(const ShapeClass& shapes, std::uint32_t first, std::uint32_t count,
                                int first_ray, std::uint64_t active) {
        for (std::uint32_t s = 0; s < count; s += lane_count<double>()) {
            const ShapeLanes<Geometry> some(shapes, first + s, count - s);
            std::uint8_t candidates[64];  // by ray: bits of shapes
            std::uint64_t tested = active;
            bool quick = false;
            if constexpr (Geometry::k_quick) {
                quick = quick_rays.usable();
                if (quick) tested = test_quickly(some, first_ray, active, candidates);
            }
            for (; tested != 0; tested &= tested - 1) {
                const int r = __builtin_ctzll(tested);
                test_shapes(shapes, some, quick ? candidates[r] : some.bits, first_ray + r);
                active &= ~finished_bit(first_ray, r);
            }
        }
    }
    HWY_INLINE std::uint64_t finished_bit(int first_ray, int r) const {
        const int i = first_ray + r;
        return std::uint64_t{!(slab_rays.t_max[i] >= slab_rays.t_min[i])} << r;
    }

    /// Finishes the rays that certainly hit, and removes them from active. Returns the others that may hit,
    /// and sets their candidates.
    template <class Geometry>
    HWY_INLINE std::uint64_t test_quickly(const ShapeLanes<Geometry>& some, int first_ray,
                                          std::uint64_t& active, std::uint8_t* candidates) {
        std::uint8_t hits[64];  // by ray: bits of shapes
        std::uint64_t hit = 0, may_hit = 0;
        // In a loop of its own, whose iterations the processor can overlap.
        const auto test_all = [&](const auto& test) HWY_ATTR {
            for (std::uint64_t rest = active; rest != 0; rest &= rest - 1) {
                const int r = __builtin_ctzll(rest);
                const auto quick = test(first_ray + r);
                hits[r] = static_cast<std::uint8_t>(to_bits(quick.is_hit) & some.bits);
                candidates[r] = static_cast<std::uint8_t>(to_bits(quick.may_hit) & some.bits);
                hit |= std::uint64_t{hits[r] != 0} << r;
                may_hit |= std::uint64_t{candidates[r] != 0} << r;
            }
        };
        if (quick_rays.parallel()) {
            using Test = typename Geometry::template ParallelTest<Doubles>;
            const auto test =
                Test::of(some.p, quick_rays.frame(), Test::k_double_slack, Doubles(quick_rays.start_along()));
            test_all([&](int i) HWY_ATTR { return test.test(quick_rays.one(i)); });
        } else {
            const Doubles start(quick_rays.start()), away(quick_rays.away());
            test_all([&](int i) HWY_ATTR {
                return Geometry::quick_test(some.p, one_ray(i), quick_rays.length_2(i), start, away);
            });
        }
        for (; hit != 0; hit &= hit - 1) {
            const int r = __builtin_ctzll(hit);
            for (std::uint32_t bits = hits[r]; bits != 0; bits &= bits - 1)
                result.occlude(first_ray + r, some.surface(*this, __builtin_ctz(bits)));
            active &= ~finished_bit(first_ray, r);
        }
        return may_hit & active;
    }

    /// Tests one ray with the shapes `bits`.
    template <class Geometry>
    HWY_INLINE void test_shapes(const ShapeClass& shapes, const ShapeLanes<Geometry>& some,
                                std::uint32_t bits, int i) {
        const Doubles t_min(rays.t_min[i]);
        RaySlab boxes;
        if constexpr (!Geometry::k_cheap) {
            meet_boxes<Geometry>(shapes, some.slot, i, boxes);
            bits &= boxes.meets;
            if (bits == 0) return;
        }
        const auto hit = formula_of_ray<Geometry>(some.p, i, t_min);
        bits &= to_bits(hit.valid);
        if (bits == 0) return;
        if constexpr (Geometry::k_cheap) {
            meet_boxes<Geometry>(shapes, some.slot, i, boxes);
            bits &= boxes.meets;
        }
        const Doubles t = min(max(hit.t, widen(boxes.entry)), widen(boxes.exit));
        bits &= to_bits(t > t_min && t <= Doubles(result.nearest.t[i]));
        if (bits == 0) return;
        alignas(64) double lanes[lane_count<double>()];
        store(t, lanes);
        for (; bits != 0; bits &= bits - 1) {
            const int lane = __builtin_ctz(bits);
            // An earlier lane may have reduced the limit.
            if (lanes[lane] <= result.nearest.t[i]) result.accept(i, lanes[lane], some.surface(*this, lane));
        }
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
