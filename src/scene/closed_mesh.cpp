// SPDX-License-Identifier: Apache-2.0
#include "scene/closed_mesh.h"

#include "base/sort_stably.h"

namespace glint {

std::vector<std::uint32_t> first_vertices(std::span<const Vec3> positions) {
    std::vector<std::uint32_t> order(positions.size()), first(positions.size());
    for (std::uint32_t v = 0; v < positions.size(); ++v) order[v] = v;
    sort_stably(order, [&](std::uint32_t i, std::uint32_t k) {
        const Vec3 &a = positions[i], &b = positions[k];
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_known = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = is_known ? first[order[i - 1]] : order[i];
    }
    return first;
}

std::vector<MeshEdge> edges_of(std::span<const TriangleCorners> triangles,
                               std::span<const std::uint32_t> first) {
    std::vector<MeshEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = first[triangles[i][k]], to = first[triangles[i][(k + 1) % 3]];
            if (from < to) edges.push_back({from, to, i, k, true});
            if (from > to) edges.push_back({to, from, i, k, false});
        }
    }
    sort_stably(edges, [](const MeshEdge& a, const MeshEdge& b) {
        return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    return edges;
}

std::optional<std::uint32_t> find_open_edge(std::span<const MeshEdge> edges) {
    std::optional<std::uint32_t> open;
    for_each_edge(edges, [&](std::span<const MeshEdge> edge) {
        std::ptrdiff_t forward = 0;
        for (const MeshEdge& of : edge) forward += of.is_forward ? 1 : -1;
        if (forward != 0 && !open) open = edge.front().triangle;
    });
    return open;
}

std::optional<std::uint32_t> find_open_triangle(const MeshData& mesh) {
    std::vector<Vec3> positions(mesh.vertex_count());
    for (std::uint32_t v = 0; v < positions.size(); ++v) positions[v] = mesh.position(v);
    return find_open_edge(edges_of(mesh.triangles, first_vertices(positions)));
}

bool is_inside_out(const MeshData& mesh) {
    double volume = 0;
    const Vec3 from = mesh.position(0);
    for (const TriangleCorners& corners : mesh.triangles) {
        const Vec3 a = mesh.position(corners[0]) - from, b = mesh.position(corners[1]) - from,
                   c = mesh.position(corners[2]) - from;
        volume += dot(a, cross(b, c));
    }
    return volume < 0;
}

}  // namespace glint
