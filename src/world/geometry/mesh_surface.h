// SPDX-License-Identifier: Apache-2.0
#pragma once
// The colors of a triangle of a shape's mesh, and where in it a point is.
#include <optional>

#include "glint/scene.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// The color at a point in the world: the corners' colors, weighted by the point's barycentric coordinates
/// in the triangle. Not set if the shape has no mesh, or the triangle no colors.
ShapeColor mesh_color(const PackedGeometry& geometry, SurfaceId id, Vec3 point);

/// The texture coordinates at a point in the world, likewise interpolated; z is 0. Nothing if the triangle
/// has none.
std::optional<Vec3> mesh_texture_coordinates(const PackedGeometry& geometry, SurfaceId id, Vec3 point);

/// The largest color of the triangle's corners, by channel.
ShapeColor brightest_mesh_color(const PackedGeometry& geometry, SurfaceId id);

/// Where a point of a triangle of a shape's mesh is.
struct MeshPlace {
    Vec3 weights;  // of the corners
    Vec3 point;    // in the mesh's coordinates
};
std::optional<MeshPlace> mesh_place(const PackedGeometry& geometry, SurfaceId id, Vec3 point);

}  // namespace glint
