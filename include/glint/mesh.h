// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles with common vertices, that shapes of the kind `mesh` refer to.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "glint/vec.h"

namespace glint {

/// Three numbers in single precision, as in most files of meshes.
struct Float3 {
    float x = 0, y = 0, z = 0;
    friend bool operator==(const Float3&, const Float3&) = default;
};
constexpr Vec3 to_vec3(const Float3& f) { return {f.x, f.y, f.z}; }
constexpr Float3 to_single(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The numbers of a triangle's three vertices, or of the values at them.
using TriangleCorners = std::array<std::uint32_t, 3>;

/// Normals, colors or texture coordinates at the corners of a mesh's triangles.
struct CornerValues {
    /// As the number of a value: the triangle has none.
    static constexpr std::uint32_t k_none = 0xffffffff;

    std::vector<Float3> values;
    /// By triangle: the numbers of the values at its corners. Empty: each vertex has a value.
    std::vector<TriangleCorners> corners;

    bool empty() const { return values.empty(); }
    friend bool operator==(const CornerValues&, const CornerValues&) = default;
};

/// The vertices and triangles of a mesh, in object coordinates. A Scene and its copies share it
/// (Scene::meshes), so it must not change once it is in a Scene.
struct MeshData {
    // The positions of the vertices, in the precision of their source: one of these lists is empty.
    std::vector<Float3> single_positions;
    std::vector<Vec3> positions;
    /// Three vertices each, counter-clockwise on the side of the normal. A triangle without area is never
    /// hit.
    std::vector<TriangleCorners> triangles;
    /// Of any length. A triangle without normals, or with a normal of (0, 0, 0), is flat.
    CornerValues normals;
    /// Linear, at least 0. They replace the color of the shape (ShapeColor), and are interpolated.
    CornerValues colors;
    /// u and v of textures (Texture), any finite numbers; z is not used. Interpolated. A triangle without
    /// them has no texture.
    CornerValues texture_coordinates;

    std::size_t vertex_count() const {
        return single_positions.empty() ? positions.size() : single_positions.size();
    }
    /// (0, 0, 0) if there is no such vertex.
    Vec3 position(std::uint32_t vertex) const {
        if (vertex >= vertex_count()) return {};
        return single_positions.empty() ? positions[vertex] : to_vec3(single_positions[vertex]);
    }
    /// The values at the corners of a triangle. Not set if one is missing, or if there is no such triangle.
    std::optional<std::array<Float3, 3>> corner_values(const CornerValues& of, std::size_t triangle) const {
        const std::vector<TriangleCorners>& corners = of.corners.empty() ? triangles : of.corners;
        if (of.empty() || triangle >= corners.size()) return {};
        std::array<Float3, 3> found;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t number = corners[triangle][i];
            if (number >= of.values.size()) return {};
            found[i] = of.values[number];
        }
        return found;
    }
    /// The normals at the corners of a triangle. Not set if the triangle is flat.
    std::optional<std::array<Float3, 3>> corner_normals(std::size_t triangle) const {
        const std::optional<std::array<Float3, 3>> found = corner_values(normals, triangle);
        if (!found) return {};
        for (const Float3& n : *found) {
            if (n == Float3{}) return {};
        }
        return found;
    }
    friend bool operator==(const MeshData&, const MeshData&) = default;
};

}  // namespace glint
