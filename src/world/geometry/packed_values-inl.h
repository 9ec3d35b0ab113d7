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

/// The first n values of the shapes in slots [slot, slot + lanes) of a class, by lane.
template <int n> HWY_INLINE void load_values(const ShapeClass& shapes, std::uint32_t slot, Doubles* p) {
    for (int k = 0; k < n; ++k) p[k] = load(shapes.column(k) + (slot - shapes.first));
}

/// Those of one slot, in all lanes. T: a number or lanes of numbers; of single precision, if Element is.
template <int n, class Element = double, class T>
HWY_INLINE void broadcast_values(const ShapeClass& shapes, std::uint32_t slot, T* p) {
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
