// SPDX-License-Identifier: Apache-2.0
// clipped_by with a box or a plane: the parts of triangles that are inside, and cuts outside the picture.
#include <algorithm>
#include <array>

#include "formats/povray/clip.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

using HalfSpace = Clip::HalfSpace;

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

// The points of a camera's picture are eye + offset + s way, s > 0.
struct Line {
    Vec3 offset, way;
};

std::array<Line, 4> picture_corners(const Camera& camera) {
    const CameraFrame frame = camera.frame.value_or(CameraFrame{});
    std::array<Line, 4> out;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 side = frame.right * (i & 1 ? 0.5 : -0.5) + frame.up * (i & 2 ? 0.5 : -0.5);
        const bool is_orthographic = camera.projection == Projection::orthographic;
        out[i] = is_orthographic ? Line{side, frame.forward} : Line{{0, 0, 0}, frame.forward + side};
    }
    return out;
}

}  // namespace

std::shared_ptr<const Clip> clip_of(const Object& clip, const Object& object, const Missing& missing) {
    auto out = make_counted<Clip>();
    out->map = object.map;
    out->missing = missing;
    Vec3 lo, hi;
    if (clip.map || clip.is_inverse || !clip.missing.empty() || !bounds_of(object, lo, hi)) return out;
    const auto least = [](double n, double a, double b) { return std::max(n * a, n * b); };
    for (const HalfSpace& half : half_spaces(clip)) {
        const Vec3& n = half.n;
        if (least(n.x, lo.x, hi.x) + least(n.y, lo.y, hi.y) + least(n.z, lo.z, hi.z) > half.d) {
            out->halves.push_back(half);
        }
    }
    out->reach = std::max(length(lo), length(hi)) * 2;
    return out;
}

bool is_seen(const Clip& clip, const Scene& scene) {
    if (clip.halves.empty()) return true;
    for (const HalfSpace& half : clip.halves) {
        for (const Line& line : picture_corners(scene.camera)) {
            // The corner ray to beyond the shape: straight, so that its ends decide.
            const Vec3 from = scene.camera.position + line.offset;
            const double far = (length(from) + clip.reach) / length(line.way);
            const double most = std::max(dot(half.n, from), dot(half.n, from + line.way * far));
            const double size = number::abs(half.d) + far * length(line.way);
            if (!(most <= half.d + 1e-9 * size)) return true;
        }
    }
    return false;
}

bool clip_mesh(const Object& clip, Object& object) {
    const std::vector<HalfSpace> halves = half_spaces(clip);
    if (object.kind != ObjectKind::mesh || object.map || clip.map || clip.is_inverse ||
        !clip.missing.empty() || halves.empty())
        return false;
    const ReadMesh& mesh = *object.mesh;
    auto cut = make_counted<ReadMesh>();
    cut->textures = mesh.textures;
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
        const bool has_normals = ReadMesh::has(mesh.normal_corners, face);
        const bool has_texture = ReadMesh::has(mesh.texture_corners, face);
        const TriangleCorners textures = has_texture ? mesh.texture_corners[face] : TriangleCorners{};
        const bool has_textures = textures[0] != textures[1] || textures[0] != textures[2];
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners.push_back({to_vec3(mesh.vertices[mesh.triangles[face][i]]),
                               has_normals ? to_vec3(mesh.normals[mesh.normal_corners[face][i]]) : Vec3{}});
        }
        const std::size_t whole = corners.size();
        bool is_cut = false;
        for (const HalfSpace& half : halves) {
            for (const Corner& c : corners) is_cut = is_cut || dot(half.n, c.point) > half.d;
            if (is_cut) corners = part_in(corners, half);
        }
        if (is_cut && has_textures && corners.size() >= whole) return false;  // three colors to blend
        for (std::size_t i = 2; i < corners.size(); ++i) {
            const auto first = static_cast<std::uint32_t>(cut->vertices.size());
            const TriangleCorners part{first, first + 1, first + 2};
            for (const std::size_t k : {std::size_t{0}, i - 1, i}) {
                cut->vertices.push_back(to_single(corners[k].point));
                cut->normals.push_back(to_single(corners[k].normal));
            }
            if (has_normals) ReadMesh::set(cut->normal_corners, cut->triangles.size(), part);
            if (has_texture) ReadMesh::set(cut->texture_corners, cut->triangles.size(), textures);
            cut->triangles.push_back(part);
        }
    }
    object.mesh = std::move(cut);
    return true;
}

}  // namespace glint::povray
