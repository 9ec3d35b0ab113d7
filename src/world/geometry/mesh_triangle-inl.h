// SPDX-License-Identifier: Apache-2.0
// The triangles of a shape's mesh: their vertices, their normals, and where in one of them a point is.
#if defined(GLINT_WORLD_MESH_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_WORLD_MESH_TRIANGLE_INL_H_
#undef GLINT_WORLD_MESH_TRIANGLE_INL_H_
#else
#define GLINT_WORLD_MESH_TRIANGLE_INL_H_
#endif

#include <array>

#include "geometry/kinds-inl.h"
#include "world/geometry/packed_mesh.h"
#include "world/geometry/packed_values-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The mesh of a shape of the kind `mesh`.
inline const PackedMesh& mesh_of(const PackedGeometry& geometry, const ShapeClass& shapes,
                                 std::uint32_t slot) {
    return *geometry.meshes[static_cast<std::size_t>(shapes.value(MeshGeometry::k_mesh, slot))];
}

inline Triangle mesh_triangle(const MeshData& mesh, std::uint32_t element) {
    const TriangleCorners& corners = mesh.triangles[element];
    return {{mesh.position(corners[0]), mesh.position(corners[1]), mesh.position(corners[2])}};
}

/// The barycentric coordinates of a point in the world: at least 0, with a sum of 1 but for rounding.
inline std::array<double, 3> mesh_barycentrics(const ShapeClass& shapes, const MeshData& mesh, SurfaceId id,
                                               Vector3<double> point) {
    double p[MeshGeometry::k_values], q[TriangleGeometry::k_values];
    broadcast_values<MeshGeometry::k_values>(shapes, id.slot, p);
    TriangleGeometry::pack(mesh_triangle(mesh, id.element), q);
    std::array<double, 3> weights = SmoothTriangleGeometry::areas(q, AffineMap::affine(p, point));
    double sum = 0;
    for (double& w : weights) w = w > 0 ? w : 0, sum += w;
    if (!(sum > 0)) return {1, 0, 0};
    for (double& w : weights) w /= sum;
    return weights;
}

/// In the world, at a point of the world. face: of any length.
struct MeshNormals {
    Vector3<double> shading, face;
};
inline MeshNormals mesh_normals(const PackedGeometry& geometry, const ShapeClass& shapes, SurfaceId id,
                                Vector3<double> point) {
    double p[MeshGeometry::k_values];
    broadcast_values<MeshGeometry::k_values>(shapes, id.slot, p);
    const MeshData& mesh = *mesh_of(geometry, shapes, id.slot).data;
    const Triangle flat = mesh_triangle(mesh, id.element);
    double q[SmoothTriangleGeometry::k_values];
    TriangleGeometry::pack(flat, q);
    const Vector3<double> face = SmoothTriangleGeometry::face_normal(q);
    Vector3<double> shading = face;
    if (const auto normals = mesh.corner_normals(id.element)) {
        SmoothTriangle smooth{{flat.vertices[0], flat.vertices[1], flat.vertices[2]}, {}};
        for (std::size_t i = 0; i < 3; ++i) smooth.normals[i] = to_vec3((*normals)[i]);
        SmoothTriangleGeometry::pack(smooth, q);
        shading = SmoothTriangleGeometry::normal(q, AffineMap::affine(p, point));
    }
    return {normalize(AffineMap::to_world_normal(p, shading)), AffineMap::to_world_normal(p, face)};
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
