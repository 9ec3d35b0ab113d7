// SPDX-License-Identifier: Apache-2.0
// The stage between a hit and its light: the hits of a stream one after the other, with their point, normal,
// direction to the eye and material.
#if defined(GLINT_TRACE_SURFACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SURFACE_INL_H_
#undef GLINT_TRACE_SURFACE_INL_H_
#else
#define GLINT_TRACE_SURFACE_INL_H_
#endif

#include "geometry/kinds-inl.h"
#include "trace/tile.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Takes the hits among rays [i, end) of the stream, at most a vector of them.
HWY_INLINE void append_hits(const WorldParts& world, TileScratch& s, int first, int i, int end, bool camera) {
    const Doubles t = load(s.t.data() + i);
    const auto hit =
        t < Doubles(k_infinity) && first_lanes<double>(end - i);  // a ray that misses keeps its t_max
    const int count_here = count(hit);
    if (count_here == 0) return;
    const auto from = [&](int column) HWY_ATTR { return load(s.rays.column(column) + first + i); };
    const Triple<Doubles> origin{from(k_ray_origin), from(k_ray_origin + 1), from(k_ray_origin + 2)},
        direction{from(k_ray_direction), from(k_ray_direction + 1), from(k_ray_direction + 2)};
    const Triple<Doubles> point = origin + direction * t;
    const int h = s.hits;
    compress_triple(point, hit, s.point, h);
    compress_triple(direction, hit, s.incoming, h);
    compress_store(max_abs(origin) + max_abs(point), hit, s.magnitude.data() + h);
    compress_store(s.slot.data() + i, hit, s.hit_slot.data() + h);
    if (camera) {
        store_triple(lanes_of(Vec3{1, 1, 1}), s.weight, h);
        compress_store(Doubles(static_cast<double>(first + i)) + iota(), hit, s.target.data() + h);
    } else {
        for (int c = 0; c < 3; ++c) compress_store(from(k_ray_weight + c), hit, s.weight[c].data() + h);
        compress_store(from(k_ray_target), hit, s.target.data() + h);
    }
    if (world.conventions.beer > 0) {
        compress_store(t, hit, s.hit_t.data() + h);
        const Doubles medium = camera ? Doubles(static_cast<double>(k_none)) : from(k_ray_medium);
        compress_store(medium, hit, s.medium.data() + h);
    }
    s.hits += count_here;
}

/// Takes the hits of rays [from, to) of the stream that begins with ray `first`, group by group.
inline void collect_hits(const WorldParts& world, TileScratch& s, int first, int from, int to,
                         int generation) {
    s.hits = s.groups = 0;
    std::size_t group = s.rays.group_of(first + from);
    for (int i = from; i < to; ++group) {
        const int end = number::min(s.rays.group_end(group) - first, to);
        for (; i < end; i += lane_count<double>()) append_hits(world, s, first, i, end, generation == 0);
        i = end;
        s.group_end[static_cast<std::size_t>(s.groups++)] = {end, s.hits};
    }
}

/// The unit normals of a vector of slots' shapes, at a point of each. items: by lane, within the class.
struct NormalsAt {
    const ShapeClass& shapes;
    const std::uint32_t* items;
    bool same;  // one item
    Triple<Doubles> point, normal;
    template <class Geometry> HWY_INLINE void visit() {
        Doubles p[Geometry::k_values];
        for (int k = 0; k < Geometry::k_values; ++k) {
            p[k] =
                same ? Doubles(shapes.column(k)[items[0]]) : gather(shapes.column(k), GatherIndices(items));
        }
        normal = Geometry::normal(p, point);
    }
};

/// The normals of a vector of hits, one class of shapes after the other.
HWY_INLINE Triple<Doubles> normals_at(const PackedGeometry& geometry, const std::uint32_t* slots, bool same,
                                      Triple<Doubles> point) {
    Triple<Doubles> normal = point;
    std::uint32_t left = (1u << lane_count<double>()) - 1;
    while (left != 0) {
        const std::uint32_t slot = slots[__builtin_ctz(left)];
        const ShapeClass& shapes = geometry.class_of(slot);
        std::uint32_t items[lane_count<double>()], here = 0;
        for (int k = 0; k < lane_count<double>(); ++k) {
            const bool in = slots[k] - shapes.first < shapes.count;
            items[k] = (in ? slots[k] : slot) - shapes.first;
            here |= static_cast<std::uint32_t>(in) << k;
        }
        NormalsAt at{shapes, items, same, point, point};
        visit_geometry(shapes.kind, shapes.transformed, at);
        normal = select_triple(from_bits<double>(here), at.normal, normal);
        left &= ~here;
    }
    return normal;
}

/// The largest coordinate of a bounded shape: its formula's rounding is relative to that too, however near to
/// the world's origin the ray is.
HWY_INLINE double max_coordinate(const PackedGeometry& geometry, std::uint32_t slot) {
    if (slot >= geometry.bounded) return 0;
    const Aabb box = primitive_bounds(geometry, slot);
    float reach = 0;
    for (int a = 0; a < 3; ++a) reach = max(reach, max(-box.lo[a], box.hi[a]));
    return reach;
}

/// Fills the columns of the hits from what collect_hits took.
inline void compute_surfaces(const WorldParts& world, TileScratch& s, int generation) {
    if (s.hits == 0) return;
    // Lanes past the last hit are computed with, though nothing of them is kept.
    std::fill_n(s.hit_slot.begin() + s.hits, k_ray_padding, s.hit_slot[static_cast<std::size_t>(s.hits - 1)]);
    const bool eye_apart = world.camera.has_lighting_eye && generation == 0;
    for (int h = 0; h < s.hits; h += lane_count<double>()) {
        const std::uint32_t* slots = s.hit_slot.data() + h;
        std::uint32_t* materials = s.material.data() + h;
        const bool same = all_same(slots);
        alignas(k_ray_alignment) double reach[lane_count<double>()];
        std::uint32_t flips = 0;
        for (int k = 0; k < (same ? 1 : lane_count<double>()); ++k) {
            reach[k] = max_coordinate(*world.geometry, slots[k]);
            materials[k] = (*world.slot_material)[slots[k]];
            flips |= static_cast<std::uint32_t>(world.flips_normal(slots[k])) << k;
        }
        if (same) {
            std::fill_n(materials + 1, lane_count<double>() - 1, materials[0]);
            flips = flips != 0 ? (1u << lane_count<double>()) - 1 : 0;
        }
        const Triple<Doubles> point = load_triple(s.point, h), d = load_triple(s.incoming, h);
        const Triple<Doubles> normal = normals_at(*world.geometry, slots, same, point);
        const auto behind = dot(normal, d) > Doubles(0);
        const auto flipped = behind && from_bits<double>(flips);
        store_triple(select_triple(flipped, -normal, normal), s.normal, h);
        store(select(behind, Doubles(1), Doubles(0)), s.behind.data() + h);

        Triple<Doubles> eye = eye_apart ? lanes_of(world.camera.lighting_eye) - point : -d;
        if (world.conventions.normalize) eye = normalize(eye);
        store_triple(eye, s.to_eye, h);
        store(load(s.magnitude.data() + h) + (same ? Doubles(reach[0]) : load(reach)),
              s.magnitude.data() + h);
    }
    // A group of hits begins anywhere: its last vector may reach past those above.
    std::fill_n(s.material.begin() + s.hits, k_ray_padding, s.material[static_cast<std::size_t>(s.hits - 1)]);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
