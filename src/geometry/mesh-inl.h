// SPDX-License-Identifier: Apache-2.0
// An instance of a mesh: the packed values that map rays into the mesh's coordinates, and normals back.
#if defined(GLINT_GEOMETRY_MESH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_MESH_INL_H_
#undef GLINT_GEOMETRY_MESH_INL_H_
#else
#define GLINT_GEOMETRY_MESH_INL_H_
#endif

#include "geometry/traits.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Packed as object_from_world row by row (AffineMap), the index in PackedGeometry::meshes, and the largest
/// number that the map adds up: the rounding errors of mapped coordinates are relative to it.
struct MeshGeometry : GeometryTraits {
    static constexpr int k_values = 14;
    static constexpr int k_mesh = 12, k_magnitude = 13;
    static constexpr bool k_bakes_transform = true;
    static constexpr bool k_is_instance = true;
    static constexpr bool k_has_formula = false;
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
