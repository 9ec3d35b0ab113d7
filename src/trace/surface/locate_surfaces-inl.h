// SPDX-License-Identifier: Apache-2.0
// The stage that computes the surface points of the hits, by kind of shape. Later stages do not ask for the
// kind.
#if defined(GLINT_TRACE_LOCATE_SURFACES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_LOCATE_SURFACES_INL_H_
#undef GLINT_TRACE_LOCATE_SURFACES_INL_H_
#else
#define GLINT_TRACE_LOCATE_SURFACES_INL_H_
#endif

#include "geometry/kinds-inl.h"
#include "trace/batches.h"
#include "world/appearance/appearance.h"
#include "world/geometry/mesh_triangle-inl.h"
#include "world/geometry/packed_values-inl.h"
#include "world/geometry/primitive_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The normals of a vector of surfaces of one class, each at its point.
struct NormalsAt {
    const PackedGeometry& geometry;
    const ShapeClass& shapes;
    const std::uint32_t* slots;
    const std::uint32_t* elements;  // null: shapes have one element
    bool same;                      // all lanes have the same slot
    bool wants_faces;               // else `face` is not computed
    Vector3<Doubles> point, shading, face;
    template <class Geometry> HWY_INLINE void visit() {
        if constexpr (Geometry::k_is_instance)
            of_meshes();
        else if constexpr (Geometry::k_has_formula)
            compute<Geometry>();
    }
    template <class Geometry> HWY_INLINE void compute() {
        Doubles p[Geometry::k_values];
        if (same)
            broadcast_values<Geometry::k_values>(shapes, slots[0], p);
        else
            gather_values<Geometry::k_values>(shapes, slots, p);
        shading = Geometry::normal(p, point);
        if (wants_faces) face = face_normal<Geometry>(p, shading);
    }
    HWY_NOINLINE void of_meshes() {
        alignas(k_ray_alignment) double at[3][lane_count<double>()], columns[6][lane_count<double>()];
        store_vector3(point, at, 0);
        for (int k = 0; k < lane_count<double>(); ++k) {
            const MeshNormals normals =
                mesh_normals(geometry, shapes, {slots[k], elements[k]}, {at[0][k], at[1][k], at[2][k]});
            const double all[6] = {normals.shading.x, normals.shading.y, normals.shading.z,
                                   normals.face.x,    normals.face.y,    normals.face.z};
            for (int c = 0; c < 6; ++c) columns[c][k] = all[c];
        }
        shading = {load(columns[0]), load(columns[1]), load(columns[2])};
        face = {load(columns[3]), load(columns[4]), load(columns[5])};
    }
};

/// The normals of a vector of hits.
struct NormalLanes {
    Vector3<Doubles> shading, face;  // as SurfaceNormals; face: shading, unless faces are wanted
};

/// Computes the normals of a vector of hits for one class of shapes after the other.
HWY_INLINE NormalLanes normals_at(const PackedGeometry& geometry, const std::uint32_t* slots,
                                  const std::uint32_t* elements, bool same, bool wants_faces,
                                  Vector3<Doubles> point) {
    NormalLanes normals{point, point};
    std::uint32_t left = (1u << lane_count<double>()) - 1;
    while (left != 0) {
        const int leader = __builtin_ctz(left);
        const std::uint32_t slot = slots[leader];
        const ShapeClass& shapes = geometry.class_of(slot);
        std::uint32_t of_class[lane_count<double>()], elements_of_class[lane_count<double>()], here = 0;
        for (int k = 0; k < lane_count<double>(); ++k) {
            const bool in = slots[k] - shapes.first < shapes.count;
            of_class[k] = in ? slots[k] : slot;
            if (elements != nullptr) elements_of_class[k] = elements[in ? k : leader];
            here |= static_cast<std::uint32_t>(in) << k;
        }
        NormalsAt at{geometry, shapes, of_class, elements_of_class, same, wants_faces, point, point, point};
        visit_geometry(shapes.kind, shapes.transformed, at);
        const auto mask = from_bits<double>(here);
        normals.shading = select_vector3(mask, at.shading, normals.shading);
        if (wants_faces) normals.face = select_vector3(mask, at.face, normals.face);
        left &= ~here;
    }
    if (!geometry.operands.empty()) {
        std::uint32_t inverted = 0;
        for (int k = 0; k < lane_count<double>(); ++k)
            inverted |= static_cast<std::uint32_t>(geometry.is_inverted(slots[k])) << k;
        const auto turned = from_bits<double>(inverted);
        normals.shading = select_vector3(turned, -normals.shading, normals.shading);
        normals.face = select_vector3(turned, -normals.face, normals.face);
    }
    if (!wants_faces) normals.face = normals.shading;
    return normals;
}

/// The largest coordinate of a bounded shape or operand, 0 for unbounded ones. The rounding error of the
/// shape's formula is relative to it too, even if the ray is near the world's origin.
HWY_INLINE double max_coordinate(const PackedGeometry& geometry, std::uint32_t slot) {
    if (slot >= geometry.bounded) {
        const PackedOperand* const operand = geometry.operand_of(slot);
        return operand != nullptr ? operand->reach : 0;
    }
    const Aabb box = primitive_bounds(geometry, slot);
    float reach = 0;
    for (int a = 0; a < 3; ++a) reach = max(reach, max(-box.lo[a], box.hi[a]));
    if (!geometry.meshes.empty()) {
        const ShapeClass& shapes = geometry.class_of(slot);
        if (shapes.kind == ShapeKind::mesh) return reach + shapes.value(MeshGeometry::k_magnitude, slot);
    }
    return reach;
}

/// Computes what the surfaces' shapes determine: the normal, turned by the conventions, the side from which
/// the ray comes, the direction to the eye, and the magnitude of the numbers.
inline void locate_surfaces(const WorldParts& world, SurfaceBatch& surfaces) {
    const int count = surfaces.count;
    if (count == 0) return;
    // Padding: lanes past the last hit are computed as well, and need valid surfaces.
    const auto last = static_cast<std::size_t>(count - 1);
    std::fill_n(surfaces.slot.begin() + count, k_ray_padding, surfaces.slot[last]);
    const bool has_elements = world.geometry->has_elements();
    if (has_elements) std::fill_n(surfaces.element.begin() + count, k_ray_padding, surfaces.element[last]);
    const bool has_lighting_eye = world.camera.has_lighting_eye &&
                                  (surfaces.generation == 0 || world.fault == TracerFault::eye_everywhere);
    const bool by_winding = world.conventions.facing == Facing::winding;
    const bool flips_by_shape = world.conventions.facing == Facing::open;
    constexpr std::uint32_t all_lanes = (1u << lane_count<double>()) - 1;
    const std::uint32_t flips_of_all = !flips_by_shape && flips_normal(world, {}) ? all_lanes : 0;
    for (int h = 0; h < count; h += lane_count<double>()) {
        const std::uint32_t* slots = surfaces.slot.data() + h;
        const bool same = all_same(slots);
        alignas(k_ray_alignment) double reach[lane_count<double>()];
        std::uint32_t flips = flips_of_all;
        for (int k = 0; k < (same ? 1 : lane_count<double>()); ++k) {
            reach[k] = max_coordinate(*world.geometry, slots[k]);
            if (flips_by_shape) flips |= static_cast<std::uint32_t>(flips_normal(world, {slots[k], 0})) << k;
        }
        if (same && flips != 0) flips = all_lanes;
        const Vector3<Doubles> point = load_vector3(surfaces.point, h),
                               d = load_vector3(surfaces.incoming, h);
        const NormalLanes normals =
            normals_at(*world.geometry, slots, has_elements ? surfaces.element.data() + h : nullptr, same,
                       by_winding, point);
        const auto behind = dot(normals.face, d) > Doubles(0);
        const auto flipped = behind && from_bits<double>(flips);
        store_vector3(select_vector3(flipped, -normals.shading, normals.shading), surfaces.normal, h);
        store(select(behind, Doubles(1), Doubles(0)), surfaces.behind.data() + h);

        Vector3<Doubles> eye = has_lighting_eye ? lanes_of(world.camera.lighting_eye) - point : -d;
        if (world.conventions.normalize) eye = normalize(eye);
        store_vector3(eye, surfaces.to_eye, h);
        double* const magnitude = surfaces.magnitude.data() + h;
        store(load(magnitude) + (same ? Doubles(reach[0]) : load(reach)), magnitude);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
