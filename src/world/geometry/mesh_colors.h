// SPDX-License-Identifier: Apache-2.0
#pragma once
// The colors of a triangle of a shape's mesh.
#include "glint/scene.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// The color at a point in the world: the corners' colors, weighted by the point's barycentric coordinates
/// in the triangle. Not set if the shape has no mesh, or the triangle no colors.
ShapeColor mesh_color(const PackedGeometry& geometry, SurfaceId id, Vec3 point);

/// The largest color of the triangle's corners, by channel.
ShapeColor brightest_mesh_color(const PackedGeometry& geometry, SurfaceId id);

}  // namespace glint
