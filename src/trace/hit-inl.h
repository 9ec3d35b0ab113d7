// What a ray hits. The hit rule, here and nowhere else:
//   a ray hits a shape at t if the shape's formula says so and the ray meets the shape's own padded box by
//   the hierarchy's slab expression; t is clamped into that interval and must lie in (t_min, t_max); nearest
//   is the least (t, index in the scene).
// Nothing in it depends on how rays are grouped or on the tree.
#if defined(GLINT_TRACE_HIT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_HIT_INL_H_
#undef GLINT_TRACE_HIT_INL_H_
#else
#define GLINT_TRACE_HIT_INL_H_
#endif

#include "bvh/traverse-inl.h"
#include "geometry/kinds-inl.h"
#include "trace/hit_declarations-inl.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The answer of nearest_hit or any_hit, as it grows. By ray of the beam.
struct HitResult {
    const World& world;
    double* t;               // the least so far; starts as t_max
    std::uint32_t* slot;     // nearest_hit: k_none at first
    std::uint8_t* occluded;  // any_hit; null for nearest_hit

    /// Which of two slots hit at the same t is seen: the first in the scene; of the triangles of one polygon,
    /// the first packed.
    HWY_INLINE bool precedes(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t shape_a = world.shape_index[a], shape_b = world.shape_index[b];
        return shape_a < shape_b || (shape_a == shape_b && a < b);
    }

    /// new_t is at most t[ray], which may be t_max itself.
    HWY_INLINE void accept(Beam& beam, int ray, double new_t, std::uint32_t new_slot) const {
        if (occluded != nullptr) {
            if (new_t == t[ray] || (world.material[new_slot] & k_no_shadow) != 0) return;
            occluded[ray] = 1;
            beam.t_max[ray] = -std::numeric_limits<float>::infinity();
            return;
        }
        if (new_t == t[ray] && (slot[ray] == k_none || precedes(slot[ray], new_slot))) return;
        t[ray] = new_t;
        slot[ray] = new_slot;
        beam.t_max[ray] = float_above(new_t);
    }
};

/// Tests shapes against the rays of a beam. `rays` are the beam's.
struct ShapeTests {
    const World& world;
    const RaySpan& rays;
    Beam& beam;
    const HitResult& result;

    HWY_INLINE Ray<Doubles> ray_lanes(int i) const {
        return {{load(rays.ox + i), load(rays.oy + i), load(rays.oz + i)},
                {load(rays.dx + i), load(rays.dy + i), load(rays.dz + i)}};
    }
    HWY_INLINE Ray<Doubles> one_ray(int i) const {
        return {{Doubles(rays.ox[i]), Doubles(rays.oy[i]), Doubles(rays.oz[i])},
                {Doubles(rays.dx[i]), Doubles(rays.dy[i]), Doubles(rays.dz[i])}};
    }

    /// A leaf: slots [first, first + count), of one class.
    HWY_INLINE void visit(std::uint32_t first, std::uint32_t count) {
        const ShapeClass& shapes = world.class_of(first);
        LeafVisitor visitor{*this, shapes, first, count};
        visit_geometry(shapes.kind, shapes.transformed, visitor);
    }
    /// All shapes of an unbounded class: no boxes.
    HWY_INLINE void visit_unbounded(const ShapeClass& shapes) {
        UnboundedVisitor visitor{*this, shapes};
        visit_geometry(shapes.kind, shapes.transformed, visitor);
    }

    struct LeafVisitor {
        ShapeTests& tests;
        const ShapeClass& shapes;
        std::uint32_t first, count;
        // With few rays the lanes are filled with shapes, with many, with rays.
        template <class Geometry> HWY_INLINE void visit() {
            if constexpr (Geometry::k_bounded) {
                if (tests.beam.count <= 2) {
                    for (int i = 0; i < tests.beam.count; ++i)
                        tests.one_ray_many_shapes<Geometry>(shapes, first, count, i);
                } else {
                    for (std::uint32_t s = first; s < first + count; ++s)
                        tests.many_rays_one_shape<Geometry>(shapes, s);
                }
                tests.beam.update_t_max();
            }
        }
    };
    struct UnboundedVisitor {
        ShapeTests& tests;
        const ShapeClass& shapes;
        template <class Geometry> HWY_INLINE void visit() {
            if constexpr (!Geometry::k_bounded) {
                for (std::uint32_t s = shapes.first; s < shapes.first + shapes.count; ++s) {
                    tests.many_rays_unbounded<Geometry>(shapes, s);
                }
                tests.beam.update_t_max();
            }
        }
    };

    template <class Geometry, class T>
    HWY_INLINE void broadcast_values(const ShapeClass& shapes, std::uint32_t slot, T* p) const {
        for (int k = 0; k < Geometry::k_values; ++k) p[k] = T(shapes.column(k)[slot - shapes.first]);
    }

    /// Settles candidates of rays [i, i + lanes): bits says which may still hit; entry and exit are their box
    /// intervals.
    template <class Geometry>
    HWY_INLINE void settle_rays(const Doubles* p, std::uint32_t slot, int i, std::uint32_t bits,
                                Doubles entry, Doubles exit) {
        const Doubles t_min = load(rays.t_min + i);
        const auto candidate = Geometry::hit(p, ray_lanes(i), t_min);
        const Doubles t = min(max(candidate.t, entry), exit);
        bits &= to_bits(candidate.hit && t > t_min && t <= load(result.t + i));
        if (bits == 0) return;
        alignas(64) double lanes[lane_count<double>()];
        store(t, lanes);
        for (; bits != 0; bits &= bits - 1) {
            const int lane = __builtin_ctz(bits);
            result.accept(beam, i + lane, lanes[lane], slot);
        }
    }

    template <class Geometry>
    HWY_NOINLINE void many_rays_one_shape(const ShapeClass& shapes, std::uint32_t slot) {
        const float lo[3] = {world.box_lo[0][slot], world.box_lo[1][slot], world.box_lo[2][slot]};
        const float hi[3] = {world.box_hi[0][slot], world.box_hi[1][slot], world.box_hi[2][slot]};
        Doubles p[Geometry::k_values];
        bool loaded = false;
        for (int i = 0; i < beam.count; i += lane_count<float>()) {
            const Slab slab = box_slab(beam, i, lo, hi);
            auto meets = slab.entry <= slab.exit && slab.entry <= load(beam.t_max + i) &&
                         slab.exit >= load(beam.t_min + i);
            if constexpr (Geometry::k_filtered) {
                if (!any(meets)) continue;
                Floats q[Geometry::k_values];
                for (int k = 0; k < Geometry::k_values; ++k) {
                    q[k] = Floats(static_cast<float>(shapes.column(k)[slot - shapes.first]));
                }
                const Ray<Floats> ray{
                    {load(beam.origin[0] + i), load(beam.origin[1] + i), load(beam.origin[2] + i)},
                    {load(beam.direction[0] + i), load(beam.direction[1] + i), load(beam.direction[2] + i)}};
                meets = meets && Geometry::may_hit(q, ray);
            }
            const std::uint32_t bits = to_bits(meets);
            if (bits == 0) continue;
            if (!loaded) broadcast_values<Geometry>(shapes, slot, p);
            loaded = true;
            alignas(64) float entry[lane_count<float>()], exit[lane_count<float>()];
            store(slab.entry, entry);
            store(slab.exit, exit);
            for (int c = 0; c < lane_count<float>(); c += lane_count<double>()) {
                const std::uint32_t part = bits >> c & ((1u << lane_count<double>()) - 1);
                if (part != 0) settle_rays<Geometry>(p, slot, i + c, part, widen(entry + c), widen(exit + c));
            }
        }
    }

    template <class Geometry>
    HWY_NOINLINE void many_rays_unbounded(const ShapeClass& shapes, std::uint32_t slot) {
        Doubles p[Geometry::k_values];
        broadcast_values<Geometry>(shapes, slot, p);
        const Doubles infinity(std::numeric_limits<double>::infinity());
        for (int i = 0; i < beam.count; i += lane_count<double>()) {
            const int lanes = number::min(beam.count - i, lane_count<double>());
            settle_rays<Geometry>(p, slot, i, (1u << lanes) - 1, -infinity, infinity);
        }
    }

    template <class Geometry>
    HWY_NOINLINE void one_ray_many_shapes(const ShapeClass& shapes, std::uint32_t first, std::uint32_t count,
                                          int i) {
        const Ray<Doubles> ray = one_ray(i);
        const Doubles t_min(rays.t_min[i]);
        for (std::uint32_t s = 0; s < count; s += lane_count<float>()) {
            const float* lo[3] = {&world.box_lo[0][first + s], &world.box_lo[1][first + s],
                                  &world.box_lo[2][first + s]};
            const float* hi[3] = {&world.box_hi[0][first + s], &world.box_hi[1][first + s],
                                  &world.box_hi[2][first + s]};
            const Slab slab = boxes_slab(beam, i, lo, hi);
            const auto meets = slab.entry <= slab.exit && slab.entry <= Floats(beam.t_max[i]) &&
                               slab.exit >= Floats(beam.t_min[i]);
            const std::uint32_t here =
                number::min(count - s, static_cast<std::uint32_t>(lane_count<float>()));
            const std::uint32_t bits = to_bits(meets) & ((1u << here) - 1);
            if (bits == 0) continue;
            alignas(64) float entry[lane_count<float>()], exit[lane_count<float>()];
            store(slab.entry, entry);
            store(slab.exit, exit);
            for (int c = 0; c < lane_count<float>(); c += lane_count<double>()) {
                std::uint32_t part = bits >> c & ((1u << lane_count<double>()) - 1);
                if (part == 0) continue;
                const std::uint32_t slot = first + s + static_cast<std::uint32_t>(c);
                Doubles p[Geometry::k_values];
                for (int k = 0; k < Geometry::k_values; ++k)
                    p[k] = load(shapes.column(k) + (slot - shapes.first));
                const auto candidate = Geometry::hit(p, ray, t_min);
                const Doubles t = min(max(candidate.t, widen(entry + c)), widen(exit + c));
                part &= to_bits(candidate.hit && t > t_min && t <= Doubles(result.t[i]));
                alignas(64) double lanes[lane_count<double>()];
                store(t, lanes);
                for (; part != 0; part &= part - 1) {
                    const int lane = __builtin_ctz(part);
                    // The limit may have shrunk since.
                    if (lanes[lane] <= result.t[i])
                        result.accept(beam, i, lanes[lane], slot + static_cast<std::uint32_t>(lane));
                }
            }
        }
    }
};

/// The rays of the span from number `first` on.
HWY_INLINE RaySpan from(const RaySpan& r, int first) {
    return {r.ox + first, r.oy + first, r.oz + first,    r.dx + first,
            r.dy + first, r.dz + first, r.t_min + first, r.t_max + first};
}

template <bool ordered>
HWY_INLINE void trace_beam(const World& world, const RaySpan& rays, int count, const HitResult& result) {
    Beam beam;
    make_beam(rays, 0, count, beam);
    ShapeTests tests{world, rays, beam, result};
    for (const ShapeClass& shapes : world.classes) {
        if (shapes.first >= world.bounded) tests.visit_unbounded(shapes);
    }
    traverse<ordered>(world.bvh, beam, tests);
}

/// A beam's directions differ by this much at most, relative to their size. Measured on the sphereflake of
/// 7,381 spheres: 0.05 and below 0.85 s, 0.1 1.1 s, 0.3 4.8 s, any spread 25 s (and single rays 1.1 s).
inline constexpr double k_spread = 0.05;

/// How many of rays [first, first + most) go nearly the way of the first: they walk together, since a beam
/// meets every box that lies between its rays.
HWY_INLINE int bundle(const RaySpan& r, int first, int most) {
    const double x = r.dx[first], y = r.dy[first], z = r.dz[first];
    const double near = k_spread * (number::abs(x) + number::abs(y) + number::abs(z));
    int n = 1;
    for (; n < most; ++n) {
        const int i = first + n;
        if (!(number::abs(r.dx[i] - x) + number::abs(r.dy[i] - y) + number::abs(r.dz[i] - z) <= near)) break;
    }
    return n;
}

void nearest_hit(const World& world, const RaySpan& rays, int count, int beam, double* t,
                 std::uint32_t* slot) {
    for (int first = 0, n = 0; first < count; first += n) {
        n = bundle(rays, first, number::min(beam, count - first));
        for (int i = first; i < first + n; ++i) {
            t[i] = rays.t_max[i];
            slot[i] = k_none;
        }
        trace_beam<true>(world, from(rays, first), n, {world, t + first, slot + first, nullptr});
    }
}

void any_hit(const World& world, const RaySpan& rays, int count, int beam, std::uint8_t* occluded) {
    double t[k_beam + k_ray_padding];
    for (int first = 0, n = 0; first < count; first += n) {
        n = bundle(rays, first, number::min(beam, count - first));
        for (int i = 0; i < n; ++i) {
            t[i] = rays.t_max[first + i];
            occluded[first + i] = 0;
        }
        trace_beam<false>(world, from(rays, first), n, {world, t, nullptr, occluded + first});
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
