// SPDX-License-Identifier: Apache-2.0
// Meshes to the Scene: each is stored once, in its own coordinates, for all places where it stands.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/add_shape.h"
#include "formats/povray/closed_mesh.h"
#include "scene/validate_shapes.h"

namespace glint::povray {
namespace {

constexpr std::uint64_t k_most_uncounted_bytes = 1u << 22;  // of meshes that are not yet in the budget

bool is_clear_somewhere(const ReadMesh& mesh, const Texture& texture) {
    const auto is_so = [](const auto& part) { return is_clear(*part); };
    return is_clear(texture) || std::any_of(mesh.textures.begin(), mesh.textures.end(), is_so);
}

}  // namespace

// The mesh in parts of one look. Null after an error.
MeshParts* SceneBuilder::parts_of(const Object& object) {
    PlacedMesh& placed = meshes_[object.mesh.get()];
    if (placed.has_parts) return &placed.parts;
    const std::uint64_t bytes = bytes_of_parts(*object.mesh);
    if (!stream_.has_room(bytes, object.at)) return nullptr;
    stream_.allow_steps(object.mesh->triangles.size());
    if ((uncounted_bytes_ += bytes) > k_most_uncounted_bytes) {
        uncounted_bytes_ = 0;
        if (!stream_.is_within_memory(object.at)) return nullptr;
    }
    placed.mesh = object.mesh;
    placed.has_parts = true;
    placed.parts = mesh_parts(*object.mesh);
    return &placed.parts;
}

// Light fades by the side of the faces from which it comes.
void SceneBuilder::place_mesh(const Object& o, const Inherited& own, bool will_be_cut) {
    const bool is_cut = own.in_solid || own.clips;
    if (is_cut || will_be_cut) {
        Object closed = o;
        closed.mesh = closed_mesh(o.mesh);
        return is_cut ? place_faces(closed, own) : place_mesh(closed, own, false);
    }
    if (!(fade_of(own).distance > 0) || !is_clear_somewhere(*o.mesh, *own.texture))
        return place_faces(o, own);
    if (!o.mesh->closed.is_known && !stream_.spend(o.mesh->triangles.size())) return;
    const std::shared_ptr<const ReadMesh> turned = outward_mesh(o.mesh);
    if (!turned) {
        report({"fade_distance", "of a mesh that is open", stream_.call_place(o.at)});
        return place_faces(o, own);
    }
    Object facing = o;
    facing.mesh = turned;
    const std::size_t first = scene_.shapes.size();
    place_faces(facing, own);
    if (o.stands_for.empty() && !o.mesh->has_inside)
        fading_meshes_.push_back({first, scene_.shapes.size(), o.at});
}

void SceneBuilder::place_faces(const Object& o, const Inherited& own) {
    const ReadMesh& mesh = *o.mesh;
    if (mesh.triangles.empty()) return;
    if (mesh.far) {
        return stream_.error(o.at, fmt::format("vertex {}: expected coordinates within 1e12, found {}",
                                               mesh.far->first, text(mesh.far->second)));
    }
    if (mesh.triangles.size() == 1 && mesh.uv.empty() && place_single_face(o, own)) return;
    MeshParts* const parts = parts_of(o);
    if (parts == nullptr || !stream_.spend(parts->parts.size() + parts->warned.size())) return;
    if (!parts->parts.empty() && !stream_.count_shapes(parts->parts.size() - 1))
        return stream_.error(o.at, fmt::format("more than {} shapes", stream_.max_shapes()));
    Inherited part_own = own;
    part_own.uv_source = mesh.uv.empty() ? UvSource::unknown : UvSource::vertices;
    for (const auto& texture : parts->warned) {
        part_own.texture = texture.get();
        report_texture(part_own, o.at);
    }
    for (MeshPart& part : parts->parts) {
        if (stream_.failed()) return;
        part_own.texture = part.texture ? part.texture.get() : own.texture;
        part_own.texture_map = part.texture ? own.map : own.texture_map;
        if (part.index == CornerValues::k_none) {
            part.index = static_cast<std::uint32_t>(scene_.meshes.size());
            scene_.meshes.push_back(part.data);
        }
        add(Mesh{part.index}, material_of(part_own, o.at), own.map, o.at);
    }
    for (const std::uint32_t face : parts->blended) {
        if (stream_.failed()) return;
        add_blended_face(o, own, face);
    }
}

// A mesh of one face, of which some programs write many thousands: as a triangle, or gathered with others.
// False if it is neither.
bool SceneBuilder::place_single_face(const Object& o, const Inherited& own) {
    const ReadMesh& mesh = *o.mesh;
    Inherited face_own = own;
    if (ReadMesh::has(mesh.texture_corners, 0)) {
        const TriangleCorners& corners = mesh.texture_corners[0];
        const Texture& first = *mesh.textures[corners[0]];
        if (corners[0] != corners[1] || corners[0] != corners[2]) {
            const Looks looks(mesh);
            return looks.count() == 1 && is_linear_in_color(first) && gather_face(o, own, first);
        }
        face_own.texture = &first;
        face_own.texture_map = own.map;
    }
    const bool is_smooth = ReadMesh::has(mesh.normal_corners, 0);
    // POV-Ray mixes the normals before the transform: of a triangle the same only if it keeps angles.
    if (own.map && is_smooth && !(similarity(*own.map) > 0)) return false;
    std::optional<Affine> object_from_world;
    if (own.map && !(object_from_world = inverse(*own.map))) {
        stream_.error(o.at, "the mesh's transform leaves nothing of it");
        return true;
    }
    SmoothTriangle t;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 p = to_vec3(mesh.vertices[mesh.triangles[0][i]]);
        t.vertices[i] = own.map ? transform_point(*own.map, p) : p;
        if (!is_smooth) continue;
        const Vec3 n = to_vec3(mesh.normals[mesh.normal_corners[0][i]]);
        t.normals[i] = object_from_world ? transform_normal(*object_from_world, n) : n;
    }
    const std::uint32_t material = material_of(face_own, o.at);
    if (is_smooth) {
        add(t, material, nullptr, o.at);
    } else {
        add(Triangle{{t.vertices[0], t.vertices[1], t.vertices[2]}}, material, nullptr, o.at);
    }
    return true;
}

// A face with three colors: into the mesh of those before it that look the same, whose place it has then.
bool SceneBuilder::gather_face(const Object& o, const Inherited& own, const Texture& texture) {
    const ReadMesh& mesh = *o.mesh;
    if (own.map || is_quiet_) return false;
    for (const auto& of : mesh.textures)
        if (has_warnings(*of)) return false;
    const Texture colorless = without_color(texture);
    Inherited face_own = own;
    face_own.texture = &colorless;
    const std::uint32_t material = material_of(face_own, o.at);
    // In fog, an object that light passes through has an inside of its own.
    if (scene_.materials[material].is_transparent()) return false;
    const bool is_smooth = ReadMesh::has(mesh.normal_corners, 0);
    if (!gathered_.data || gathered_.material != material || gathered_.is_smooth != is_smooth ||
        gathered_.is_hollow != own.is_hollow) {
        gathered_ = {std::make_shared<MeshData>(), material, is_smooth, own.is_hollow};
        reading_.memory.set_growing(gathered_.data);
        scene_.meshes.push_back(gathered_.data);
        add(Mesh{static_cast<std::uint32_t>(scene_.meshes.size() - 1)}, material, nullptr, o.at);
    }
    MeshData& data = *gathered_.data;
    const auto first = static_cast<std::uint32_t>(data.single_positions.size());
    data.triangles.push_back({first, first + 1, first + 2});
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& c = mesh.textures[mesh.texture_corners[0][i]]->pigment.color;
        data.single_positions.push_back(mesh.vertices[mesh.triangles[0][i]]);
        data.colors.values.push_back(to_single({c[0], c[1], c[2]}));
        if (is_smooth) data.normals.values.push_back(mesh.normals[mesh.normal_corners[0][i]]);
    }
    return true;
}

}  // namespace glint::povray
