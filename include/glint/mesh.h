// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles with common vertices, that shapes of the kind `mesh` refer to.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glint/vec.h"

namespace glint {

/// Three numbers in single precision, as in most files of meshes.
struct Float3 {
    float x = 0, y = 0, z = 0;
    friend bool operator==(const Float3&, const Float3&) = default;
};
constexpr Vec3 to_vec3(const Float3& f) { return {f.x, f.y, f.z}; }

/// The vertices and triangles of a mesh, in object coordinates. A Scene and its copies share it
/// (Scene::meshes), so it must not change once it is in a Scene.
struct MeshData {
    // The positions of the vertices, in the precision of their source: one of these lists is empty.
    std::vector<Float3> single_positions;
    std::vector<Vec3> positions;
    /// By vertex, of any length; empty: the triangles are flat. A triangle with a normal of (0, 0, 0) is
    /// flat, too.
    std::vector<Float3> normals;
    /// Three vertices each, counter-clockwise on the side of the normal. A triangle without area is never
    /// hit.
    std::vector<std::array<std::uint32_t, 3>> triangles;

    std::size_t vertex_count() const {
        return single_positions.empty() ? positions.size() : single_positions.size();
    }
    /// (0, 0, 0) if there is no such vertex.
    Vec3 position(std::uint32_t vertex) const {
        if (vertex >= vertex_count()) return {};
        return single_positions.empty() ? positions[vertex] : to_vec3(single_positions[vertex]);
    }
    /// Whether a triangle has interpolated normals. false if there is no such triangle.
    bool is_smooth(std::size_t triangle) const {
        if (normals.empty() || triangle >= triangles.size()) return false;
        for (const std::uint32_t v : triangles[triangle]) {
            if (v >= normals.size() || normals[v] == Float3{}) return false;
        }
        return true;
    }
    friend bool operator==(const MeshData&, const MeshData&) = default;
};

}  // namespace glint
