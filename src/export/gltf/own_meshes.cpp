// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/own_meshes.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "math/number.h"
#include "math/transform.h"
#include "world/appearance/texture.h"

namespace glint::gltf_export {

MeshData transformed(const MeshData& mesh, const Affine& map) {
    MeshData to = mesh;
    to.positions.clear();
    to.single_positions.clear();
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        to.positions.push_back(transform_point(map, mesh.position(v)));
    if (const std::optional<Affine> back = inverse(map)) {
        for (Float3& n : to.normals.values) n = to_single(normalize(transform_normal(*back, to_vec3(n))));
    } else {
        to.normals = {};
    }
    if (determinant(map) < 0) {
        for (auto* const corners :
             {&to.triangles, &to.normals.corners, &to.colors.corners, &to.texture_coordinates.corners}) {
            for (TriangleCorners& triangle : *corners) std::swap(triangle[1], triangle[2]);
        }
    }
    return to;
}

MeshData with_coordinates(const MeshData& mesh, const Affine& world_from_mesh, const Texture& texture) {
    MeshData to = mesh;
    to.texture_coordinates = {};
    const Affine texture_from_mesh =
        compose(inverse(texture.world_from_texture).value_or(Affine{}), world_from_mesh);
    const bool goes_around = texture.mapping != TextureMapping::planar;
    for (const TriangleCorners& triangle : mesh.triangles) {
        TexturePlace at[3];
        bool is_pole[3] = {};
        double most = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p = transform_point(texture_from_mesh, mesh.position(triangle[k]));
            at[k] = place_on(texture, p);
            is_pole[k] = goes_around && number::abs(p.x) + number::abs(p.z) < 1e-6 * number::abs(p.y);
            if (!is_pole[k]) most = std::max(most, at[k].u);
        }
        double sum = 0, count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (is_pole[k]) continue;
            if (goes_around && most - at[k].u > 0.5) at[k].u += 1;
            sum += at[k].u;
            count += 1;
        }
        // Around a pole there is every u: that of the middle of the triangle.
        TriangleCorners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            if (is_pole[k] && count > 0) at[k].u = sum / count;
            corners[k] = static_cast<std::uint32_t>(to.texture_coordinates.values.size());
            to.texture_coordinates.values.push_back(to_single({at[k].u, at[k].v, 0}));
        }
        to.texture_coordinates.corners.push_back(corners);
    }
    return to;
}

}  // namespace glint::gltf_export
