// SPDX-License-Identifier: Apache-2.0
#include "formats/single_vertices.h"

namespace glint {
namespace {

constexpr std::uint32_t k_last = CornerValues::k_none;  // of the vertices at one position

}  // namespace

SingleVertices single_vertices(const MeshData& mesh, VertexValues values,
                               const std::vector<std::uint32_t>* triangles) {
    static const CornerValues k_no_values;
    const CornerValues& normals = values.normals ? mesh.normals : k_no_values;
    const CornerValues& colors = values.colors ? mesh.colors : k_no_values;
    const CornerValues& coordinates = values.texture_coordinates ? mesh.texture_coordinates : k_no_values;
    SingleVertices single;
    const auto count = static_cast<std::uint32_t>(mesh.vertex_count());
    if (triangles == nullptr && normals.corners.empty() && colors.corners.empty() &&
        coordinates.corners.empty()) {
        single.vertices.reserve(count);
        for (std::uint32_t v = 0; v < count; ++v) single.vertices.push_back({v, v, v, v});
        single.triangles = mesh.triangles;
        return single;
    }
    const auto number_of = [&](const CornerValues& of, std::size_t triangle, std::size_t corner) {
        if (of.empty()) return CornerValues::k_none;
        return (of.corners.empty() ? mesh.triangles : of.corners)[triangle][corner];
    };
    // By position: its first vertex; by vertex: the next one at the same position.
    std::vector<std::uint32_t> first(count, k_last), next;
    const std::size_t wanted = triangles != nullptr ? triangles->size() : mesh.triangles.size();
    single.triangles.reserve(wanted);
    for (std::size_t t = 0; t < wanted; ++t) {
        const std::size_t i = triangles != nullptr ? (*triangles)[t] : t;
        TriangleCorners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const SingleVertex vertex{mesh.triangles[i][k], number_of(normals, i, k), number_of(colors, i, k),
                                      number_of(coordinates, i, k)};
            std::uint32_t at = first[vertex[0]];
            while (at != k_last && single.vertices[at] != vertex) at = next[at];
            if (at == k_last) {
                at = static_cast<std::uint32_t>(single.vertices.size());
                single.vertices.push_back(vertex);
                next.push_back(first[vertex[0]]);
                first[vertex[0]] = at;
            }
            corners[k] = at;
        }
        single.triangles.push_back(corners);
    }
    return single;
}

}  // namespace glint
