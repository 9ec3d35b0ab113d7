// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "formats/povray/object.h"

namespace glint::povray {

/// Whether the vertices of a triangle of a closed mesh are counterclockwise seen from outside. Takes a time
/// in proportion to the mesh's triangles.
bool faces_outwards(const ReadMesh& mesh, std::size_t triangle);

/// Whether a point is in a closed mesh. Takes a time in proportion to its triangles.
bool is_in_mesh(const ReadMesh& mesh, Vec3 point);

}  // namespace glint::povray
