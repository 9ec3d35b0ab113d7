// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether triangles enclose a space.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "glint/mesh.h"

namespace glint {

/// By vertex: the first one at its position.
std::vector<std::uint32_t> first_vertices(std::span<const Vec3> positions);

/// An edge of a triangle.
struct MeshEdge {
    std::uint32_t low = 0, high = 0;  ///< the first vertices at the positions of its ends
    std::uint32_t triangle = 0;
    std::uint32_t side = 0;   ///< from this corner of the triangle to the next one
    bool is_forward = false;  ///< that is from `low` to `high`
};

/// The edges of all triangles, with those between the same positions one after the other. first: by vertex.
std::vector<MeshEdge> edges_of(std::span<const TriangleCorners> triangles,
                               std::span<const std::uint32_t> first);

/// Calls use(edges) for those between the same positions.
template <class Use> void for_each_edge(std::span<const MeshEdge> edges, const Use& use) {
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        while (end < edges.size() && edges[end].low == edges[begin].low &&
               edges[end].high == edges[begin].high)
            ++end;
        use(edges.subspan(begin, end - begin));
    }
}

/// A triangle with an edge that does not have as many triangles in one direction as in the other. Without
/// any, the triangles enclose a space, and their normals point all out of it or all into it.
std::optional<std::uint32_t> find_open_edge(std::span<const MeshEdge> edges);

/// The same, of a valid mesh. Takes n log n steps.
std::optional<std::uint32_t> find_open_triangle(const MeshData& mesh);

/// Whether the triangles of a closed mesh are clockwise seen from outside: its volume is below 0.
bool is_inside_out(const MeshData& mesh);

}  // namespace glint
