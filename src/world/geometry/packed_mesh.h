// SPDX-License-Identifier: Apache-2.0
#pragma once
// A mesh with a hierarchy of its own, which all shapes that have the mesh share.
#include <memory>
#include <vector>

#include "glint/mesh.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

struct PackedMesh {
    std::shared_ptr<const MeshData> data;
    PackedGeometry geometry;  // the triangles, in the mesh's coordinates; their elements are their numbers
    Vec3 lo, hi;              // the box of the vertices that the triangles have
};

}  // namespace glint
