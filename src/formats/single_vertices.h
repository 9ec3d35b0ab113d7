// SPDX-License-Identifier: Apache-2.0
#pragma once
// A mesh as files with one list of vertices have it.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glint/mesh.h"

namespace glint {

/// What a vertex of the file has: the numbers of its position, normal, color and texture coordinates.
using SingleVertex = std::array<std::uint32_t, 4>;

struct SingleVertices {
    std::vector<SingleVertex> vertices;
    std::vector<TriangleCorners> triangles;
};

/// Which values the vertices of the file have.
struct VertexValues {
    bool normals = true, colors = true, texture_coordinates = true;
};

/// Vertices that differ in one of these numbers are several; they are in the order of their first use. A
/// number of values that the file or the mesh does not have is CornerValues::k_none. triangles: the numbers
/// of the mesh's triangles that are wanted; null: all. The mesh must be without mistakes (validate_mesh.h).
SingleVertices single_vertices(const MeshData& mesh, VertexValues values = {},
                               const std::vector<std::uint32_t>* triangles = nullptr);

}  // namespace glint
