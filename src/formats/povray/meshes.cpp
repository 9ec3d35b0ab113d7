// SPDX-License-Identifier: Apache-2.0
// mesh and mesh2.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/object_parser.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

// The unit vector; of 0 that which POV-Ray takes.
Float3 stored_normal(Vec3 v) {
    const double most = std::max({number::abs(v.x), number::abs(v.y), number::abs(v.z)});
    return most > 0 ? to_single(normalize(v / most)) : Float3{1, 0, 0};
}

}  // namespace

// mesh { triangles [inside_vector] modifiers }
Object ObjectParser::read_mesh(const Token& word) {
    Object object;
    object.kind = ObjectKind::mesh;
    object.at = word;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    auto mesh = make_counted<ReadMesh>();
    while (!failed()) {
        if (accept(Word::k_inside_vector)) {
            mesh->has_inside = !(vector() == Vec3{});
        } else if (peek().word() == Word::k_triangle || peek().word() == Word::k_smooth_triangle) {
            read_mesh_triangle(*mesh);
        } else {
            break;
        }
    }
    object.mesh = std::move(mesh);
    read_modifiers(object);
    return object;
}

void ObjectParser::read_mesh_triangle(ReadMesh& mesh) {
    const bool is_smooth = take().word() == Word::k_smooth_triangle;
    if (!expect('{')) return;
    TriangleCorners vertices{}, normals{};
    const std::size_t triangle = mesh.triangles.size();
    for (std::size_t i = 0; i < 3 && !failed(); ++i) {
        vertices[i] = mesh.add_vertex(vector());
        accept(',');
        if (!is_smooth) continue;
        normals[i] = static_cast<std::uint32_t>(mesh.normals.size());
        mesh.normals.push_back(stored_normal(vector()));
        accept(',');
    }
    if (is_smooth) ReadMesh::set(mesh.normal_corners, triangle, normals);
    while (!failed() && !accept('}')) {
        const Token item = take();
        if (item.word() == Word::k_texture) {
            TriangleCorners textures;
            textures.fill(static_cast<std::uint32_t>(mesh.textures.size()));
            ReadMesh::set(mesh.texture_corners, triangle, textures);
            mesh.textures.push_back(make_counted<const Texture>(read_texture()));
        } else if (item.word() == Word::k_uv_vectors) {
            TriangleCorners corners{};
            for (std::uint32_t& corner : corners) {
                corner = static_cast<std::uint32_t>(mesh.uv.size());
                mesh.uv.push_back(ReadMesh::stored_uv(uv_vector()));
                accept(',');
            }
            ReadMesh::set(mesh.uv_corners, triangle, corners);
        } else {
            error(item, fmt::format("expected `texture` or `}}`, found {}", describe(item)));
        }
    }
    mesh.triangles.push_back(vertices);
}

// mesh2 { vertex_vectors {...} ... modifiers }
Object ObjectParser::read_mesh2(const Token& word) {
    Object object;
    object.kind = ObjectKind::mesh;
    object.at = word;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    auto mesh = make_counted<ReadMesh>();
    bool has_normal_indices = false;
    for (bool is_part = true; is_part && !failed();) {
        const Token item = peek();
        switch (item.word()) {
            case Word::k_vertex_vectors:
                take();
                mesh->vertices = read_points(ReadMesh::stored_position, mesh.get());
                break;
            case Word::k_normal_vectors:
                take();
                mesh->normals = read_points(stored_normal);
                break;
            case Word::k_texture_list:
                take();
                read_texture_list(*mesh);
                break;
            case Word::k_face_indices:
                take();
                read_faces(*mesh);
                break;
            case Word::k_normal_indices:
                take();
                has_normal_indices = true;
                read_corner_indices(mesh->normal_corners, mesh->triangles.size());
                break;
            case Word::k_uv_vectors:
                take();
                mesh->uv = read_uv();
                break;
            case Word::k_uv_indices:
                take();
                read_corner_indices(mesh->uv_corners, mesh->triangles.size());
                break;
            case Word::k_inside_vector:
                take();
                mesh->has_inside = !(vector() == Vec3{});
                break;
            default:
                is_part = false;
        }
    }
    check_mesh(word, *mesh, has_normal_indices);
    object.mesh = std::move(mesh);
    read_modifiers(object);
    return object;
}

// Indices are in range. Without normal indices, a vertex has the normal of the same number. Without
// uv_vectors, index 0 of them is valid (measured).
void ObjectParser::check_mesh(const Token& at, ReadMesh& mesh, bool has_normal_indices) {
    if (!has_normal_indices && !mesh.normals.empty()) mesh.normal_corners = mesh.triangles;
    if (mesh.uv_corners.empty() && !mesh.uv.empty()) mesh.uv_corners = mesh.triangles;
    if (!mesh.uv_corners.empty() && mesh.uv.empty()) mesh.uv.push_back({});
    const auto is_within = [](const CountedVector<TriangleCorners>& list, std::size_t triangle,
                              std::size_t end) {
        return !ReadMesh::has(list, triangle) ||
               (list[triangle][0] < end && list[triangle][1] < end && list[triangle][2] < end);
    };
    for (std::size_t i = 0; i < mesh.triangles.size() && !failed(); ++i) {
        const TriangleCorners& vertices = mesh.triangles[i];
        if (*std::max_element(vertices.begin(), vertices.end()) < mesh.vertices.size() &&
            is_within(mesh.normal_corners, i, mesh.normals.size()) &&
            is_within(mesh.uv_corners, i, mesh.uv.size()) &&
            is_within(mesh.texture_corners, i, mesh.textures.size())) {
            continue;
        }
        error(at, fmt::format("face {} of the mesh has an index beyond its {} vertices, {} normals, {} "
                              "uv_vectors and {} textures",
                              i, mesh.vertices.size(), mesh.normals.size(), mesh.uv.size(),
                              mesh.textures.size()));
    }
}

void ObjectParser::read_texture_list(ReadMesh& mesh) {
    if (!expect('{')) return;
    const std::size_t count = read_count();
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        Texture texture = default_texture();
        if (accept(Word::k_texture)) {
            texture = read_texture();
        } else {
            const Token name = take();
            const auto held = named<Texture>(name);
            if (held == nullptr)
                return error(name, fmt::format("expected `texture`, found {}", describe(name)));
            texture = *held;
        }
        mesh.textures.push_back(make_counted<const Texture>(std::move(texture)));
        accept(',');
    }
    if (!failed()) expect('}');
}

}  // namespace glint::povray
