// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "glint/shapes.h"

namespace glint {

/// Cuts a simple polygon (convex or concave, at least 3 vertices, about flat) into triangles with the same
/// winding, by ear clipping in the coordinate plane it is most parallel to (O'Rourke, Computational Geometry
/// in C, 1998). A polygon that crosses itself, or has no area, also gives some triangles. Appends to
/// `out`.
void triangulate(std::span<const Vec3> vertices, std::vector<Triangle>& out);

}  // namespace glint
