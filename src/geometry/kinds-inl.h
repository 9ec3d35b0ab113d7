// The list of kinds: which geometry belongs to which shape. A new shape adds its file here.
#if defined(GLINT_GEOMETRY_KINDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_KINDS_INL_H_
#undef GLINT_GEOMETRY_KINDS_INL_H_
#else
#define GLINT_GEOMETRY_KINDS_INL_H_
#endif

#include "geometry/cone-inl.h"
#include "geometry/cuboid-inl.h"
#include "geometry/cylinder-inl.h"
#include "geometry/disc-inl.h"
#include "geometry/plane-inl.h"
#include "geometry/sphere-inl.h"
#include "geometry/transformed-inl.h"
#include "geometry/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Polygons are cut into triangles before anything is packed: a world has none.
struct PolygonGeometry : TriangleGeometry {};

/// Calls visitor.visit<Geometry>() for the geometry of a kind, under a transform or not.
template <class Visitor>
HWY_INLINE void visit_geometry(ShapeKind kind, bool transformed, Visitor&& visitor) {
    switch (kind) {
#define GLINT_KIND(Type, word)                                          \
    case ShapeKind::word:                                               \
        if (transformed) {                                              \
            visitor.template visit<Transformed<Type##Geometry>>();      \
        } else {                                                        \
            visitor.template visit<Type##Geometry>();                   \
        }                                                               \
        break;
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
