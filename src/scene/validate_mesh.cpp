// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_mesh.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "scene/ranges.h"
#include "scene/validate_shapes.h"

namespace glint {

namespace {

// what: a normal or a color.
std::string mistake_in(const CornerValues& of, const MeshData& mesh, std::string_view what) {
    const std::size_t triangles = mesh.triangles.size();
    if (of.corners.empty()) {
        if (!of.empty() && of.values.size() != mesh.vertex_count())
            return fmt::format("expected {} {}s, one for each vertex, found {}", mesh.vertex_count(), what,
                               of.values.size());
    } else if (of.corners.size() != triangles) {
        return fmt::format("expected the {}s of {} triangles, found those of {}", what, triangles,
                           of.corners.size());
    }
    for (std::size_t i = 0; i < of.corners.size(); ++i) {
        for (const std::uint32_t v : of.corners[i]) {
            if (v != CornerValues::k_none && v >= of.values.size())
                return fmt::format("triangle {}: expected a {} below {}, found {}", i, what, of.values.size(),
                                   v);
        }
    }
    return {};
}

}  // namespace

std::string mistake_in(const MeshData& mesh) {
    const std::size_t vertices = mesh.vertex_count();
    constexpr std::size_t most = 1u << 29;
    if (vertices > most) return fmt::format("expected at most {} vertices, found {}", most, vertices);
    if (mesh.triangles.empty()) return "expected at least one triangle, found none";
    if (!mesh.positions.empty() && !mesh.single_positions.empty())
        return "expected positions in one precision, found both";
    for (const auto& [values, what] : {std::pair{&mesh.normals, "normal"},
                                       {&mesh.colors, "color"},
                                       {&mesh.texture_coordinates, "texture coordinate"}}) {
        if (std::string mistake = mistake_in(*values, mesh, what); !mistake.empty()) return mistake;
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const std::uint32_t v : mesh.triangles[i]) {
            if (v >= vertices)
                return fmt::format("triangle {}: expected a vertex below {}, found {}", i, vertices, v);
        }
    }
    for (std::uint32_t v = 0; v < vertices; ++v) {
        if (const Vec3 p = mesh.position(v); !is_coordinate(p))
            return fmt::format("vertex {}: expected coordinates within 1e12, found {}", v, text(p));
    }
    for (std::size_t i = 0; i < mesh.normals.values.size(); ++i) {
        if (const Vec3 n = to_vec3(mesh.normals.values[i]); !is_coordinate(n))
            return fmt::format("normal {}: expected numbers within 1e12, found {}", i, text(n));
    }
    for (std::size_t i = 0; i < mesh.colors.values.size(); ++i) {
        const Vec3 c = to_vec3(mesh.colors.values[i]);
        if (!is_coordinate(c) || c.x < 0 || c.y < 0 || c.z < 0)
            return fmt::format("color {}: expected numbers from 0 to 1e12, found {}", i, text(c));
    }
    for (std::size_t i = 0; i < mesh.texture_coordinates.values.size(); ++i) {
        if (const Vec3 uv = to_vec3(mesh.texture_coordinates.values[i]); !is_coordinate(uv))
            return fmt::format("texture coordinate {}: expected numbers within 1e12, found {}", i, text(uv));
    }
    return {};
}

}  // namespace glint
