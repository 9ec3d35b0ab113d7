// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/mesh_surface.h"

#include <array>
#include <optional>

#include "glint/world.h"  // before the kernels, which have a Ray of their own
#include "world/geometry/mesh_triangle-inl.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

// Null if the shape has no mesh.
const MeshData* mesh_if_any(const PackedGeometry& geometry, const ShapeClass& shapes, SurfaceId id) {
    return shapes.kind == ShapeKind::mesh ? mesh_of(geometry, shapes, id.slot).data.get() : nullptr;
}

// The values at the corners, weighted by the point's barycentric coordinates. Nothing without values.
std::optional<Vec3> interpolated(const PackedGeometry& geometry, SurfaceId id, Vec3 point,
                                 CornerValues MeshData::*values) {
    const ShapeClass& shapes = geometry.class_of(id.slot);
    const MeshData* const mesh = mesh_if_any(geometry, shapes, id);
    if (mesh == nullptr) return {};
    const auto corners = mesh->corner_values(mesh->*values, id.element);
    if (!corners) return {};
    const std::array<double, 3> weights = mesh_barycentrics(shapes, *mesh, id, {point.x, point.y, point.z});
    Vec3 sum;
    for (std::size_t i = 0; i < 3; ++i) sum = sum + to_vec3((*corners)[i]) * weights[i];
    return sum;
}

}  // namespace

ShapeColor mesh_color(const PackedGeometry& geometry, SurfaceId id, Vec3 point) {
    const std::optional<Vec3> c = interpolated(geometry, id, point, &MeshData::colors);
    if (!c) return {};
    return {static_cast<float>(c->x), static_cast<float>(c->y), static_cast<float>(c->z)};
}

std::optional<Vec3> mesh_texture_coordinates(const PackedGeometry& geometry, SurfaceId id, Vec3 point) {
    return interpolated(geometry, id, point, &MeshData::texture_coordinates);
}

ShapeColor brightest_mesh_color(const PackedGeometry& geometry, SurfaceId id) {
    const MeshData* const mesh = mesh_if_any(geometry, geometry.class_of(id.slot), id);
    if (mesh == nullptr) return {};
    const auto colors = mesh->corner_values(mesh->colors, id.element);
    if (!colors) return {};
    ShapeColor most{0, 0, 0};
    for (const Float3& c : *colors)
        most = {number::max(most.r, c.x), number::max(most.g, c.y), number::max(most.b, c.z)};
    return most;
}

std::optional<MeshPlace> mesh_place(const PackedGeometry& geometry, SurfaceId id, Vec3 point) {
    const ShapeClass& shapes = geometry.class_of(id.slot);
    const MeshData* const mesh = mesh_if_any(geometry, shapes, id);
    if (mesh == nullptr) return {};
    double map[MeshGeometry::k_values];
    broadcast_values<MeshGeometry::k_values>(shapes, id.slot, map);
    const std::array<double, 3> weights = mesh_barycentrics(shapes, *mesh, id, {point.x, point.y, point.z});
    const Vector3<double> p = AffineMap::affine(map, Vector3<double>{point.x, point.y, point.z});
    return MeshPlace{{weights[0], weights[1], weights[2]}, {p.x, p.y, p.z}};
}

}  // namespace glint
