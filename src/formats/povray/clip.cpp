// SPDX-License-Identifier: Apache-2.0
// Meshes cut by a box or a plane: the parts of their triangles that are inside.
#include <algorithm>

#include "formats/povray/reader.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

// The points p with dot(n, p) <= d are kept.
struct HalfSpace {
    Vec3 n;
    double d = 0;
};

std::vector<HalfSpace> half_spaces(const Object& clip) {
    if (clip.kind == ObjectKind::plane) return {{normalize(clip.b), clip.s}};
    if (clip.kind != ObjectKind::box) return {};
    const Vec3 &a = clip.a, &b = clip.b;
    return {{{1, 0, 0}, std::max(a.x, b.x)},   {{0, 1, 0}, std::max(a.y, b.y)},
            {{0, 0, 1}, std::max(a.z, b.z)},   {{-1, 0, 0}, -std::min(a.x, b.x)},
            {{0, -1, 0}, -std::min(a.y, b.y)}, {{0, 0, -1}, -std::min(a.z, b.z)}};
}

struct Corner {
    Vec3 point, normal;
};

// Sutherland and Hodgman: the part of a polygon in a half space.
std::vector<Corner> part_in(const std::vector<Corner>& corners, const HalfSpace& half) {
    std::vector<Corner> out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
        const double a = half.d - dot(half.n, from.point), b = half.d - dot(half.n, to.point);
        if (a >= 0) out.push_back(from);
        if (!(a > 0 && b < 0) && !(a < 0 && b > 0)) continue;
        const double t = a / (a - b);
        out.push_back(
            {from.point + (to.point - from.point) * t, from.normal + (to.normal - from.normal) * t});
    }
    return out;
}

}  // namespace

// False if the mesh cannot be cut by this object.
bool Reader::clip_mesh(const Object& clip, Object& object) {
    const std::vector<HalfSpace> halves = half_spaces(clip);
    if (object.kind != ObjectKind::mesh || object.map || clip.map || clip.missing || halves.empty())
        return false;
    const Mesh& mesh = *object.mesh;
    auto cut = std::make_shared<Mesh>();
    cut->textures = mesh.textures;
    for (const Mesh::Face& face : mesh.faces) {
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners.push_back({mesh.vertices[face.vertices[i]],
                               face.has_normals ? mesh.normals[face.normals[i]] : Vec3{0, 0, 0}});
        }
        const std::size_t whole = corners.size();
        bool is_cut = false;
        for (const HalfSpace& half : halves) {
            for (const Corner& c : corners) is_cut = is_cut || dot(half.n, c.point) > half.d;
            if (is_cut) corners = part_in(corners, half);
        }
        if (is_cut && face.has_textures && corners.size() >= whole) return false;  // three colours to blend
        for (std::size_t i = 2; i < corners.size(); ++i) {
            Mesh::Face part = face;
            const auto first = static_cast<std::uint32_t>(cut->vertices.size());
            for (const std::size_t k : {std::size_t{0}, i - 1, i}) {
                cut->vertices.push_back(corners[k].point);
                cut->normals.push_back(corners[k].normal);
            }
            part.vertices = part.normals = {first, first + 1, first + 2};
            cut->faces.push_back(part);
        }
    }
    object.count = cut->faces.size();
    object.mesh = std::move(cut);
    return true;
}

}  // namespace glint::povray
