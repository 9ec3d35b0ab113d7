// SPDX-License-Identifier: Apache-2.0
// Reads the values of packed shapes. The formulas of geometry/ read them from here only.
#if defined(GLINT_WORLD_PACKED_VALUES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_WORLD_PACKED_VALUES_INL_H_
#undef GLINT_WORLD_PACKED_VALUES_INL_H_
#else
#define GLINT_WORLD_PACKED_VALUES_INL_H_
#endif

#include "simd/lanes-inl.h"
#include "world/geometry/packed_geometry.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The number of values of a triangle, which are those of its vertices.
inline constexpr int k_triangle_values = 9;

/// The vertices of triangles in slots [slot, slot + lanes) of a mesh, by lane.
HWY_INLINE void load_corners(const ShapeClass& shapes, std::uint32_t slot, Doubles* p) {
    const MeshData& mesh = *shapes.mesh;
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t* const corners = shapes.corner_column(k) + slot;
        if (mesh.single_positions.empty()) {
            const GatherIndices places(corners, 3);
            for (int a = 0; a < 3; ++a) *p++ = gather(&mesh.positions[0].x + a, places);
        } else {
            const SingleGatherIndices places(corners, 3);
            for (int a = 0; a < 3; ++a) *p++ = gather(&mesh.single_positions[0].x + a, places);
        }
    }
}

/// The first n values of the shapes in slots [slot, slot + lanes) of a class, by lane.
template <int n> HWY_INLINE void load_values(const ShapeClass& shapes, std::uint32_t slot, Doubles* p) {
    if constexpr (n == k_triangle_values) {
        if (shapes.mesh != nullptr) return load_corners(shapes, slot, p);
    }
    for (int k = 0; k < n; ++k) p[k] = load(shapes.column(k) + (slot - shapes.first));
}

/// Those of one slot, in all lanes. T: a number or lanes of numbers; of single precision, if Element is.
template <int n, class Element = double, class T>
HWY_INLINE void broadcast_values(const ShapeClass& shapes, std::uint32_t slot, T* p) {
    if constexpr (n == k_triangle_values) {
        if (shapes.mesh != nullptr) {
            for (int k = 0; k < 3; ++k) {
                const Vec3 v = shapes.mesh->position(shapes.corner_column(k)[slot]);
                for (const double x : {v.x, v.y, v.z}) *p++ = T(static_cast<Element>(x));
            }
            return;
        }
    }
    for (int k = 0; k < n; ++k) p[k] = T(static_cast<Element>(shapes.value(k, slot)));
}

/// Those of any slots of a class, by lane.
template <int n>
HWY_INLINE void gather_values(const ShapeClass& shapes, const std::uint32_t* slots, Doubles* p) {
    std::uint32_t items[lane_count<double>()];
    for (int i = 0; i < lane_count<double>(); ++i) items[i] = slots[i] - shapes.first;
    const GatherIndices places(items);
    for (int k = 0; k < n; ++k) p[k] = gather(shapes.column(k), places);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
