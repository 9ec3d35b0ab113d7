// SPDX-License-Identifier: Apache-2.0
// The padded boxes of packed shapes, by the hit rule: stored, or computed from the values.
#if defined(GLINT_WORLD_PRIMITIVE_BOUNDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_WORLD_PRIMITIVE_BOUNDS_INL_H_
#undef GLINT_WORLD_PRIMITIVE_BOUNDS_INL_H_
#else
#define GLINT_WORLD_PRIMITIVE_BOUNDS_INL_H_
#endif

#include "geometry/kinds-inl.h"
#include "math/aabb.h"
#include "world/geometry/packed_geometry.h"
#include "world/geometry/packed_values-inl.h"

HWY_BEFORE_NAMESPACE();
#define GLINT_NUMBER_NAMESPACE HWY_NAMESPACE
#include "math/padding_templates-inl.h"
namespace glint {
namespace HWY_NAMESPACE {

/// The padded box of a shape whose box is not stored.
struct ComputedBox {
    const ShapeClass& shapes;
    std::uint32_t slot;
    Aabb box;
    template <class Geometry> void visit() {
        if constexpr (!Geometry::k_stores_box) {
            double p[Geometry::k_bounds_values];
            broadcast_values<Geometry::k_bounds_values>(shapes, slot, p);
            const auto [lo, hi] = Geometry::packed_bounds(p);
            box = padded_box({lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z});
        }
    }
};

/// The padded box of a bounded slot's shape.
inline Aabb primitive_bounds(const PackedGeometry& geometry, std::uint32_t slot) {
    if (slot < geometry.boxed) {
        Aabb box;
        for (int a = 0; a < 3; ++a)
            box.lo[a] = geometry.box_lo[a][slot], box.hi[a] = geometry.box_hi[a][slot];
        return box;
    }
    const ShapeClass& shapes = geometry.class_of(slot);
    ComputedBox computed{shapes, slot, {}};
    visit_geometry(shapes.kind, shapes.transformed, computed);
    return computed.box;
}

/// padded_box (math/aabb.h) lane by lane: the sides of one axis.
HWY_INLINE void pad_sides(Doubles lo, Doubles hi, float* lower, float* upper) {
    const Doubles pad = box_padding(lo, hi);
    store_narrow(lo - pad, lower);
    store_narrow(hi + pad, upper);
}

/// The planes of the boxes of slots [first, first + count), count <= lanes, by axis. Further lanes are
/// unspecified.
template <class Geometry> struct PrimitiveBounds {
    const float *lo[3], *hi[3];

    HWY_INLINE PrimitiveBounds(const PackedGeometry& geometry, const ShapeClass& shapes, std::uint32_t first,
                               [[maybe_unused]] int count) {
        if constexpr (!Geometry::k_stores_box) {
            int i = 0;
            do {
                Doubles p[Geometry::k_bounds_values];
                load_values<Geometry::k_bounds_values>(shapes, first + static_cast<std::uint32_t>(i), p);
                const auto packed_bounds = Geometry::packed_bounds(p);
                pad_sides(packed_bounds.lo.x, packed_bounds.hi.x, computed_[0] + i, computed_[3] + i);
                pad_sides(packed_bounds.lo.y, packed_bounds.hi.y, computed_[1] + i, computed_[4] + i);
                pad_sides(packed_bounds.lo.z, packed_bounds.hi.z, computed_[2] + i, computed_[5] + i);
                i += lane_count<double>();
            } while (i < count);
            for (int a = 0; a < 3; ++a) lo[a] = computed_[a], hi[a] = computed_[3 + a];
        } else {
            for (int a = 0; a < 3; ++a)
                lo[a] = &geometry.box_lo[a][first], hi[a] = &geometry.box_hi[a][first];
        }
    }
    PrimitiveBounds(const PrimitiveBounds&) = delete;
    PrimitiveBounds& operator=(const PrimitiveBounds&) = delete;

  private:
    alignas(64) float computed_[6][Geometry::k_stores_box ? 1 : lane_count<float>()];
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
