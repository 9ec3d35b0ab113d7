// SPDX-License-Identifier: Apache-2.0
#pragma once
// Curved and flat shapes as meshes of one size, which nodes place. docs/formats/gltf.md states how fine they
// are.
#include "glint/mesh.h"

namespace glint::gltf_export {

inline constexpr int k_around = 64;                  ///< vertices of a circle
inline constexpr double k_row_degrees = 180.0 / 32;  ///< of a sphere's triangles, from pole to pole

/// Radius 1 around the origin. The rows of triangles begin at z = 1, the first one with this height in
/// degrees; those below are higher, in proportion to their distance, up to the usual height.
MeshData unit_sphere(double degrees = k_row_degrees);
/// Around the z axis, with these radii at z = 0 and z = 1, at least 0 and not both 0; caps: with the discs at
/// its ends.
MeshData unit_cone(double from_radius, double to_radius, bool caps);
/// Radius 1 around the z axis, with a hole of this radius, from 0 to below 1, and with the normal z.
MeshData unit_disc(double hole = 0);
/// The points at distance `tube` from the circle of radius 1 around the z axis at z = 0.
MeshData unit_torus(double tube);
/// From (0, 0, 0) to (1, 1, 1).
MeshData unit_box();
/// From (-1, -1, 0) to (1, 1, 0), with the normal z.
MeshData unit_square();

}  // namespace glint::gltf_export
