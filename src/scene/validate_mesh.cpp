// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/ranges.h"
#include "scene/validate_shapes.h"

namespace glint {

std::string mistake_in(const MeshData& mesh) {
    const std::size_t vertices = mesh.vertex_count();
    if (mesh.triangles.empty()) return "expected at least one triangle, found none";
    if (!mesh.positions.empty() && !mesh.single_positions.empty())
        return "expected positions in one precision, found both";
    if (!mesh.normals.empty() && mesh.normals.size() != vertices) {
        return fmt::format("expected {} normals, one for each vertex, found {}", vertices,
                           mesh.normals.size());
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
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        if (const Vec3 n = to_vec3(mesh.normals[v]); !is_coordinate(n))
            return fmt::format("vertex {}: expected a normal within 1e12, found {}", v, text(n));
    }
    return {};
}

}  // namespace glint
