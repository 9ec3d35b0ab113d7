// SPDX-License-Identifier: Apache-2.0
// A solid: the packed value that tells which one it is.
#if defined(GLINT_GEOMETRY_SOLID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_SOLID_INL_H_
#undef GLINT_GEOMETRY_SOLID_INL_H_
#else
#define GLINT_GEOMETRY_SOLID_INL_H_
#endif

#include "geometry/traits.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Packed as the index in PackedGeometry::solids. Its operands are packed in slots of their own, with its
/// transform.
struct SolidGeometry : GeometryTraits {
    static constexpr int k_values = 1;
    static constexpr bool k_bakes_transform = true;
    static constexpr bool k_is_solid = true;
    static constexpr bool k_has_formula = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
