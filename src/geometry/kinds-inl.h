// SPDX-License-Identifier: Apache-2.0
// The list of shape kinds and their geometries. A new shape adds its file here.
#if defined(GLINT_GEOMETRY_KINDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_KINDS_INL_H_
#undef GLINT_GEOMETRY_KINDS_INL_H_
#else
#define GLINT_GEOMETRY_KINDS_INL_H_
#endif

#include <type_traits>

#include "geometry/box-inl.h"
#include "geometry/cone-inl.h"
#include "geometry/cylinder-inl.h"
#include "geometry/disc-inl.h"
#include "geometry/mesh-inl.h"
#include "geometry/plane-inl.h"
#include "geometry/quadric-inl.h"
#include "geometry/quartic-inl.h"
#include "geometry/solid-inl.h"
#include "geometry/sphere-inl.h"
#include "geometry/torus-inl.h"
#include "geometry/transformed-inl.h"
#include "geometry/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Polygons are triangulated before packing, so a World contains none.
struct PolygonGeometry : TriangleGeometry {};
template <class Geometry> inline constexpr bool k_is_packed = !std::is_same_v<Geometry, PolygonGeometry>;

/// The normal of the face at a point, of any length; shading: the kind's normal there.
template <class Geometry, class T> HWY_INLINE Vector3<T> face_normal(const T* p, const Vector3<T>& shading) {
    if constexpr (requires { Geometry::face_normal(p); }) {
        return Geometry::face_normal(p);
    } else {
        return shading;
    }
}

/// Calls visitor.visit<Geometry>() for the geometry of a kind, with or without a transform. Kinds that apply
/// the transform to their own parameters (k_bakes_transform) are never packed with one.
template <class Geometry, class Visitor> HWY_INLINE void visit_kind(bool transformed, Visitor&& visitor) {
    if constexpr (k_is_packed<Geometry>) {
        if constexpr (!Geometry::k_bakes_transform) {
            if (transformed) return visitor.template visit<Transformed<Geometry>>();
        }
        visitor.template visit<Geometry>();
    }
}
template <class Visitor> HWY_INLINE void visit_geometry(ShapeKind kind, bool transformed, Visitor&& visitor) {
    switch (kind) {
#define GLINT_KIND(Type, word) \
    case ShapeKind::word:      \
        return visit_kind<Type##Geometry>(transformed, visitor);
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
