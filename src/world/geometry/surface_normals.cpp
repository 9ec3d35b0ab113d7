// SPDX-License-Identifier: Apache-2.0
#include "geometry/kinds-inl.h"
#include "world/geometry/mesh_triangle-inl.h"
#include "world/geometry/packed_geometry.h"
#include "world/geometry/packed_values-inl.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

struct NormalsOf {
    const PackedGeometry& geometry;
    const ShapeClass& shapes;
    SurfaceId id;
    Vector3<double> point, shading, face;
    template <class Geometry> void visit() {
        if constexpr (Geometry::k_is_instance) {
            const MeshNormals normals = mesh_normals(geometry, shapes, id, point);
            shading = normals.shading, face = normals.face;
        } else if constexpr (Geometry::k_has_formula) {
            compute<Geometry>();
        }
    }
    template <class Geometry> void compute() {
        double p[Geometry::k_values];
        broadcast_values<Geometry::k_values>(shapes, id.slot, p);
        shading = Geometry::normal(p, point);
        face = face_normal<Geometry>(p, shading);
    }
};

}  // namespace

SurfaceNormals surface_normals(const PackedGeometry& geometry, SurfaceId id, Vec3 point) {
    const ShapeClass& shapes = geometry.class_of(id.slot);
    NormalsOf of{geometry, shapes, id, {point.x, point.y, point.z}, {}, {}};
    visit_geometry(shapes.kind, shapes.transformed, of);
    SurfaceNormals normals{{of.shading.x, of.shading.y, of.shading.z}, {of.face.x, of.face.y, of.face.z}};
    if (geometry.is_inverted(id.slot)) normals = {-normals.shading, -normals.face};
    return normals;
}

}  // namespace glint
