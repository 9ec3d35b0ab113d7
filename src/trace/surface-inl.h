// SPDX-License-Identifier: Apache-2.0
// The stages that compute the surface points from the hits: point, normal, direction to the eye and material,
// compacted.
#if defined(GLINT_TRACE_SURFACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SURFACE_INL_H_
#undef GLINT_TRACE_SURFACE_INL_H_
#else
#define GLINT_TRACE_SURFACE_INL_H_
#endif

#include "geometry/kinds-inl.h"
#include "geometry/ray_offset-inl.h"
#include "math/sample_hash.h"
#include "trace/batches.h"
#include "world/primitive_bounds-inl.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The columns of append_hits() that only scenes with transparent surfaces have.
inline void append_transparent_hits(const RayBatch& rays, int ray, Doubles t, LaneMask<double> hit,
                                    const Vector3<Doubles>& origin, SurfaceBatch& surfaces) {
    const bool camera = rays.generation == 0;
    const int h = surfaces.count;
    compress_vector3(origin, hit, surfaces.origin, h);
    compress_store(t, hit, surfaces.t.data() + h);
    compress_store(camera ? Doubles(0) : load(rays.level.data() + ray), hit, surfaces.level.data() + h);
    compress_store(camera ? Doubles(0) : load(rays.passed.data() + ray), hit, surfaces.passed.data() + h);
}

/// Appends the hits among entries [i, end) of the HitBatch, at most a vector of them. plain: the surfaces
/// have no columns for alpha, transparent surfaces, hashes or fog.
template <bool plain>
HWY_INLINE void append_hits(const WorldParts& world, const RayBatch& rays, const HitBatch& hits, int i,
                            int end, SurfaceBatch& surfaces) {
    const Doubles t = load(hits.t.data() + i);
    const auto hit = t < Doubles(k_infinity) && first_lanes<double>(end - i);  // a miss has t == t_max
    const int count_here = count(hit);
    if (count_here == 0) return;
    const bool camera = rays.generation == 0;
    const int ray = hits.first + i, h = surfaces.count;
    const Vector3<Doubles> origin = load_vector3(rays.origin, ray),
                           direction = load_vector3(rays.direction, ray);
    const Vector3<Doubles> point = origin + direction * t;
    compress_vector3(point, hit, surfaces.point, h);
    compress_vector3(direction, hit, surfaces.incoming, h);
    compress_store(max_abs(origin) + max_abs(point), hit, surfaces.magnitude.data() + h);
    compress_store(hits.slot.data() + i, hit, surfaces.slot.data() + h);
    if (camera) {
        store_vector3(lanes_of(Vec3{1, 1, 1}), surfaces.weight, h);
        compress_store(Doubles(static_cast<double>(ray)) + iota(), hit, surfaces.target.data() + h);
    } else {
        compress_vector3(load_vector3(rays.weight, ray), hit, surfaces.weight, h);
        compress_store(load(rays.target.data() + ray), hit, surfaces.target.data() + h);
    }
    const bool beer = world.conventions.beer > 0, transparent = !plain && rays.transparent;
    if (!plain && rays.hashed) {
        const Doubles path =
            camera ? Doubles(static_cast<double>(k_camera_path)) : load(rays.path.data() + ray);
        compress_store(path, hit, surfaces.path.data() + h);
    }
    if (!plain && rays.alpha) {
        const Doubles straight = camera ? Doubles(1) : load(rays.straight.data() + ray);
        compress_store(straight, hit, surfaces.straight.data() + h);
    }
    if (!plain && rays.tracked)
        compress_store(load(rays.interiors.data() + ray), hit, surfaces.interiors.data() + h);
    if (transparent) append_transparent_hits(rays, ray, t, hit, origin, surfaces);
    if (beer || (!plain && world.fog)) {
        const Doubles start = transparent && !camera ? load(rays.start.data() + ray) : Doubles(0);
        compress_store(t - start, hit, surfaces.hit_t.data() + h);
    }
    if (beer) {
        const Doubles medium = camera ? Doubles(static_cast<double>(k_none)) : load(rays.medium.data() + ray);
        compress_store(medium, hit, surfaces.medium.data() + h);
    }
    surfaces.count += count_here;
}

/// Compacts the hits of a range of rays, group by group.
inline void collect_hits(const WorldParts& world, const RayBatch& rays, const HitBatch& hits, RayRange range,
                         SurfaceBatch& surfaces) {
    surfaces.generation = rays.generation;
    surfaces.alpha = rays.alpha;
    surfaces.transparent = rays.transparent;
    surfaces.hashed = rays.hashed;
    surfaces.tracked = rays.tracked;
    surfaces.count = surfaces.groups = 0;
    const bool plain = !rays.alpha && !rays.transparent && !rays.hashed && !world.fog;
    std::size_t group = rays.group_of(hits.first + range.begin);
    for (int i = range.begin; i < range.end; ++group) {
        const int end = number::min(rays.group_end(group) - hits.first, range.end);
        for (; i < end; i += lane_count<double>()) {
            if (plain) {
                append_hits<true>(world, rays, hits, i, end, surfaces);
            } else {
                append_hits<false>(world, rays, hits, i, end, surfaces);
            }
        }
        i = end;
        surfaces.group_end[static_cast<std::size_t>(surfaces.groups++)] = {end, surfaces.count};
    }
}

/// The unit normals of a vector of shapes of one class, each at its point. items: the shape's index in the
/// class, by lane.
struct NormalsAt {
    const ShapeClass& shapes;
    const std::uint32_t* items;
    bool same;  // all lanes have the same item
    Vector3<Doubles> point, normal;
    template <class Geometry> HWY_INLINE void visit() {
        Doubles p[Geometry::k_values];
        for (int k = 0; k < Geometry::k_values; ++k) {
            p[k] =
                same ? Doubles(shapes.column(k)[items[0]]) : gather(shapes.column(k), GatherIndices(items));
        }
        normal = Geometry::normal(p, point);
    }
};

/// The normals of a vector of hits, computed for one class of shapes after the other.
HWY_INLINE Vector3<Doubles> normals_at(const PackedGeometry& geometry, const std::uint32_t* slots, bool same,
                                       Vector3<Doubles> point) {
    Vector3<Doubles> normal = point;
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
        normal = select_vector3(from_bits<double>(here), at.normal, normal);
        left &= ~here;
    }
    return normal;
}

/// facing = winding: which rays hit from behind, by the faces of smooth triangles, and of other shapes by
/// `behind`.
inline LaneMask<double> behind_faces(const PackedGeometry& geometry, const std::uint32_t* slots,
                                     const Vector3<Doubles>& d, LaneMask<double> behind) {
    alignas(k_ray_alignment) double x[lane_count<double>()] = {}, y[lane_count<double>()] = {},
                                    z[lane_count<double>()] = {};
    std::uint32_t smooth = 0;
    for (int k = 0; k < lane_count<double>(); ++k) {
        if (!geometry.is_smooth_triangle(slots[k])) continue;
        const Vec3 n = geometry.face_normal(slots[k]);
        x[k] = n.x, y[k] = n.y, z[k] = n.z;
        smooth |= 1u << k;
    }
    const auto by_face = from_bits<double>(smooth);
    const auto clockwise = dot(Vector3<Doubles>{load(x), load(y), load(z)}, d) > Doubles(0);
    return (by_face && clockwise) || (behind && !by_face);
}

/// The largest coordinate of a bounded shape, 0 for unbounded ones. The rounding error of the shape's formula
/// is relative to it too, even if the ray is near the world's origin.
HWY_INLINE double max_coordinate(const PackedGeometry& geometry, std::uint32_t slot) {
    if (slot >= geometry.bounded) return 0;
    const Aabb box = primitive_bounds(geometry, slot);
    float reach = 0;
    for (int a = 0; a < 3; ++a) reach = max(reach, max(-box.lo[a], box.hi[a]));
    return reach;
}

/// Writes the values of the hits' materials with the colors of their shapes. Consecutive hits of one shape
/// share a row.
inline void color_surfaces(const WorldParts& world, SurfaceBatch& surfaces) {
    surfaces.colored_rows.resize(std::size_t{k_batch_size} * k_material_values);
    const std::uint32_t* slots = surfaces.slot.data();
    std::uint32_t* rows = surfaces.colored_row.data();
    std::uint32_t row = 0;
    for (int h = 0; h < surfaces.count; ++h) {
        if (h == 0 || slots[h] != slots[h - 1]) {
            if (h > 0) ++row;
            world.write_surface_values(slots[h],
                                       surfaces.colored_rows.data() + std::size_t{row} * k_material_values);
        }
        rows[h] = row;
    }
    std::fill_n(rows + surfaces.count, k_ray_padding, row);
    surfaces.rows = surfaces.colored_rows.data();
    surfaces.row = rows;
}

/// Computes the other columns of the surfaces: material, normal, direction to the eye.
inline void compute_surfaces(const WorldParts& world, SurfaceBatch& surfaces) {
    const int count = surfaces.count;
    if (count == 0) return;
    // Padding: lanes past the last hit are computed as well, and need valid slots.
    const auto last = static_cast<std::size_t>(count - 1);
    std::fill_n(surfaces.slot.begin() + count, k_ray_padding, surfaces.slot[last]);
    const bool has_lighting_eye = world.camera.has_lighting_eye && surfaces.generation == 0;
    const bool by_winding = world.conventions.facing == Facing::winding;
    for (int h = 0; h < count; h += lane_count<double>()) {
        const std::uint32_t* slots = surfaces.slot.data() + h;
        std::uint32_t* materials = surfaces.material.data() + h;
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
        const Vector3<Doubles> point = load_vector3(surfaces.point, h),
                               d = load_vector3(surfaces.incoming, h);
        const Vector3<Doubles> normal = normals_at(*world.geometry, slots, same, point);
        auto behind = dot(normal, d) > Doubles(0);
        if (by_winding) behind = behind_faces(*world.geometry, slots, d, behind);
        const auto flipped = behind && from_bits<double>(flips);
        store_vector3(select_vector3(flipped, -normal, normal), surfaces.normal, h);
        store(select(behind, Doubles(1), Doubles(0)), surfaces.behind.data() + h);

        Vector3<Doubles> eye = has_lighting_eye ? lanes_of(world.camera.lighting_eye) - point : -d;
        if (world.conventions.normalize) eye = normalize(eye);
        store_vector3(eye, surfaces.to_eye, h);
        double* const magnitude = surfaces.magnitude.data() + h;
        store(load(magnitude) + (same ? Doubles(reach[0]) : load(reach)), magnitude);
    }
    // The last vector of a group may extend past the vectors above, because groups start at any index.
    std::fill_n(surfaces.material.begin() + count, k_ray_padding, surfaces.material[last]);
    surfaces.rows = world.materials->data();
    surfaces.row = surfaces.material.data();
    if (!world.slot_color->empty()) color_surfaces(world, surfaces);
}

/// The surface points of a vector of hits, for the formulas of lighting and of ray origins.
HWY_INLINE SurfacePoint<Doubles> surface_at(const SurfaceBatch& surfaces, int h) {
    return {load_vector3(surfaces.point, h), load_vector3(surfaces.normal, h),
            load_vector3(surfaces.incoming, h), load(surfaces.magnitude.data() + h)};
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
