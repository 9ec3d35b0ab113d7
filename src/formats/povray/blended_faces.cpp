// SPDX-License-Identifier: Apache-2.0
// Faces of meshes whose textures at the corners differ in more than color, or have light that is not linear
// in their color: as small triangles of one color.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/add_shape.h"
#include "formats/povray/parts.h"
#include "math/number.h"

namespace glint::povray {
namespace {

// The parts of a face along a side, and the strips of one with two colors.
constexpr int k_max_parts = 32, k_max_fine_parts = 64, k_max_strips = 171;
constexpr std::uint64_t k_few_shapes = 1'000'000;

bool same_light(const Finish& a, const Finish& b) {
    return a.ambient == b.ambient && a.emission == b.emission && a.diffuse == b.diffuse &&
           a.brilliance == b.brilliance && a.phong == b.phong && a.phong_size == b.phong_size &&
           a.specular == b.specular && a.roughness == b.roughness && a.metallic == b.metallic &&
           a.reflection_max == b.reflection_max && a.reflection_min == b.reflection_min;
}

}  // namespace

// The three textures of a face are blended between its corners: by parts of one color each, whose colors
// differ by at most 1.5 of 255, or more if the three corners have very different ones.
void SceneBuilder::add_blended_face(const Object& o, const Inherited& own, std::uint32_t face) {
    const ReadMesh& mesh = *o.mesh;
    std::array<const Texture*, 3> textures{};
    std::array<Vec3, 3> points{}, normals{};
    const bool is_smooth = ReadMesh::has(mesh.normal_corners, face);
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        textures[i] = mesh.textures[mesh.texture_corners[face][i]].get();
        points[i] = to_vec3(mesh.vertices[mesh.triangles[face][i]]);
        if (is_smooth) normals[i] = to_vec3(mesh.normals[mesh.normal_corners[face][i]]);
    }
    std::optional<Affine> object_from_world;
    if (own.map && !(object_from_world = inverse(*own.map)))
        return stream_.error(o.at, "the mesh's transform leaves nothing of it");
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 5; ++k) {
            const double d = textures[i]->pigment.color[k] - textures[(i + 1) % 3]->pigment.color[k];
            most = std::max(most, number::abs(d));
        }
    }
    for (const Texture* texture : textures) {
        if (texture->pigment.missing) report(*texture->pigment.missing);
        report(texture->missing);
        if (texture->pigment.image_number != textures[0]->pigment.image_number)
            report({"image_map", "of a part of a face's corners", stream_.call_place(o.at)});
        if (texture->layers_number != textures[0]->layers_number)
            report({"layered textures", "of a part of a face's corners", stream_.call_place(o.at)});
        if (texture->pigment.color[3] != textures[0]->pigment.color[3]) {
            report({"texture_list", "with different filters at the corners of a face",
                    stream_.call_place(o.at)});
        }
        if (!same_light(texture->finish, textures[0]->finish)) {
            report({"texture_list", "with different finishes at the corners of a face",
                    stream_.call_place(o.at)});
        }
    }
    using Corners = std::array<CornerWeights, 3>;
    // colors: the part's color is their mean.
    const auto add_part = [&](const Corners& corners, const Corners& colors) {
        Texture texture = *textures[0];
        texture.pigment.color.fill(0);
        std::array<double, 3> weights{};  // of the textures
        SmoothTriangle part;
        for (std::size_t k = 0; k < 3; ++k) {
            part.vertices[k] = mixed(points[0], points[1], points[2], corners[k]);
            part.normals[k] = mixed(normals[0], normals[1], normals[2], corners[k]);
            if (own.map) {
                part.vertices[k] = transform_point(*own.map, part.vertices[k]);
                part.normals[k] = transform_normal(*object_from_world, part.normals[k]);
            }
            for (std::size_t i = 0; i < 3; ++i)
                weights[i] += mixed(i == 0 ? 1.0 : 0, i == 1 ? 1.0 : 0, i == 2 ? 1.0 : 0, colors[k]) / 3;
        }
        // POV-Ray mixes what each texture shows: the color of one that lets more light through counts less.
        const auto opacity = [&](std::size_t i) { return 1 - textures[i]->pigment.color[4]; };
        const double opaque = weights[0] * opacity(0) + weights[1] * opacity(1) + weights[2] * opacity(2);
        for (std::size_t c = 0; c < 5; ++c) {
            for (std::size_t i = 0; i < 3; ++i) {
                const double share = c < 3 && opaque > 0 ? opacity(i) / opaque : 1;
                texture.pigment.color[c] += weights[i] * share * textures[i]->pigment.color[c];
            }
        }
        Inherited part_own = own;
        part_own.texture = &texture;
        const std::uint32_t material = material_of(part_own, o.at);
        if (is_smooth) {
            add(part, material, nullptr, o.at);
        } else {
            add(Triangle{{part.vertices[0], part.vertices[1], part.vertices[2]}}, material, nullptr, o.at);
        }
        return !stream_.failed();
    };
    const auto has_room = [&](int parts) {
        if (!stream_.count_shapes(static_cast<std::uint64_t>(parts))) {
            stream_.error(
                o.at, fmt::format("the colors of this mesh take more than {} triangles: glint draws a face "
                                  "with several colors as many small triangles of one color; try fewer "
                                  "faces, or one texture for each face",
                                  stream_.max_shapes()));
        }
        return !stream_.failed();
    };
    const int steps = static_cast<int>(std::min(most, 10.0) * 170) + 1;
    for (std::size_t i = 0; i < 3 && steps > k_max_parts; ++i) {
        if (!(textures[(i + 1) % 3]->pigment == textures[(i + 2) % 3]->pigment)) continue;
        // Only one corner has another color: strips along the side opposite to it.
        const int strips = std::min(steps, k_max_strips);
        if (!has_room(2 * strips)) return;
        return for_each_strip(strips, i, [&](const Corners& corners, const CornerWeights& middle) {
            return add_part(corners, {middle, middle, middle});
        });
    }
    const int n = std::clamp(steps, 1, stream_.shapes() < k_few_shapes ? k_max_fine_parts : k_max_parts);
    if (!has_room(n * n)) return;
    for_each_part(n, [&](const Corners& corners) { return add_part(corners, corners); });
}

}  // namespace glint::povray
