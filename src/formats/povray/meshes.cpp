// SPDX-License-Identifier: Apache-2.0
// mesh and mesh2.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/object_parser.h"

namespace glint::povray {

// mesh { triangles, modifiers }
Object ObjectParser::read_mesh(const Token& word) {
    Object object;
    object.kind = ObjectKind::mesh;
    object.at = word;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    auto mesh = make_counted<Mesh>();
    while (!failed() && (peek().word() == Word::k_triangle || peek().word() == Word::k_smooth_triangle)) {
        read_mesh_triangle(*mesh);
    }
    object.count = std::max<std::uint64_t>(mesh->faces.size(), 1);
    object.mesh = std::move(mesh);
    read_modifiers(object);
    return object;
}

void ObjectParser::read_mesh_triangle(Mesh& mesh) {
    const bool is_smooth = take().word() == Word::k_smooth_triangle;
    if (!expect('{')) return;
    Mesh::Face face;
    face.has_normals = is_smooth;
    for (std::size_t i = 0; i < 3 && !failed(); ++i) {
        face.vertices[i] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(vector());
        accept(',');
        if (!is_smooth) continue;
        face.normals[i] = static_cast<std::uint32_t>(mesh.normals.size());
        mesh.normals.push_back(vector());
        accept(',');
    }
    while (!failed() && !accept('}')) {
        const Token item = take();
        if (item.word() == Word::k_texture) {
            face.has_texture = true;
            face.textures.fill(static_cast<std::uint32_t>(mesh.textures.size()));
            mesh.textures.push_back(make_counted<const Texture>(read_texture()));
        } else if (item.word() == Word::k_uv_vectors) {
            for (int i = 0; i < 3 && !failed(); ++i) {
                expression();
                accept(',');
            }
        } else {
            error(item, fmt::format("expected `texture` or `}}`, found {}", describe(item)));
        }
    }
    mesh.faces.push_back(face);
}

// mesh2 { vertex_vectors {...} ... modifiers }
Object ObjectParser::read_mesh2(const Token& word) {
    Object object;
    object.kind = ObjectKind::mesh;
    object.at = word;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    auto mesh = make_counted<Mesh>();
    bool has_normal_indices = false;
    for (bool is_part = true; is_part && !failed();) {
        const Token item = peek();
        switch (item.word()) {
            case Word::k_vertex_vectors:
                take();
                mesh->vertices = read_points();
                break;
            case Word::k_normal_vectors:
                take();
                mesh->normals = read_points();
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
                read_normal_indices(*mesh);
                break;
            case Word::k_uv_vectors:
            case Word::k_uv_indices:
            case Word::k_inside_vector:
                take();
                if (item.word() == Word::k_inside_vector) {
                    vector();
                } else {
                    skip_block();
                }
                break;
            default:
                is_part = false;
        }
    }
    check_mesh(word, *mesh, has_normal_indices);
    object.count = std::max<std::uint64_t>(mesh->faces.size(), 1);
    object.mesh = std::move(mesh);
    read_modifiers(object);
    return object;
}

// Indices are in range, and normals are not 0.
void ObjectParser::check_mesh(const Token& at, Mesh& mesh, bool has_normal_indices) {
    for (Vec3& n : mesh.normals) {
        if (n == Vec3{0, 0, 0}) n = {1, 0, 0};
    }
    for (Mesh::Face& face : mesh.faces) {
        if (!has_normal_indices && !mesh.normals.empty()) {
            face.normals = face.vertices;
            face.has_normals = true;
        }
        for (std::size_t i = 0; i < 3 && !failed(); ++i) {
            const bool is_wrong = face.vertices[i] >= mesh.vertices.size() ||
                                  (face.has_normals && face.normals[i] >= mesh.normals.size()) ||
                                  (face.has_texture && face.textures[i] >= mesh.textures.size());
            if (is_wrong) {
                error(at,
                      fmt::format("face {} of the mesh has an index beyond its {} vertices, {} normals and "
                                  "{} textures",
                                  &face - mesh.faces.data(), mesh.vertices.size(), mesh.normals.size(),
                                  mesh.textures.size()));
            }
        }
    }
}

// The number of items of a list; memory is reserved for what the text can hold.
std::size_t ObjectParser::read_count() {
    const Token at = peek();
    const double count = number();
    accept(',');
    if (!failed() && !(count >= 0 && count <= 1e9)) error(at, "expected a number of items from 0 to 1e9");
    return failed() ? 0 : static_cast<std::size_t>(count);
}

CountedVector<Vec3> ObjectParser::read_points() {
    CountedVector<Vec3> points;
    if (!expect('{')) return points;
    const std::size_t count = read_count();
    points.reserve(std::min<std::size_t>(count, 1u << 16));
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        points.push_back(vector());
        accept(',');
    }
    if (!failed()) expect('}');
    return points;
}

void ObjectParser::read_face_indices(std::array<std::uint32_t, 3>& indices) {
    if (!expect('<')) return;
    for (std::uint32_t& index : indices) {
        index = read_index();
        accept(',');
    }
    expect('>');
}

std::uint32_t ObjectParser::read_index() {
    const Token at = peek();
    const double value = number();
    if (!failed() && !(value >= 0 && value <= 4e9)) error(at, "expected an index from 0 to 4e9");
    return failed() ? 0 : static_cast<std::uint32_t>(value);
}

void ObjectParser::read_faces(Mesh& mesh) {
    if (!expect('{')) return;
    const std::size_t count = read_count();
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        Mesh::Face face;
        read_face_indices(face.vertices);
        accept(',');
        // One texture for the face, or one for each vertex.
        std::size_t textures = 0;
        while (!failed() && textures < 3 && !peek().is('<') && begins_number(peek())) {
            face.textures[textures++] = read_index();
            accept(',');
        }
        face.has_texture = textures > 0;
        if (textures == 1) face.textures[1] = face.textures[2] = face.textures[0];
        if (textures == 2) expected("a third texture of the face");
        face.has_textures = face.has_texture &&
                            (face.textures[0] != face.textures[1] || face.textures[0] != face.textures[2]);
        mesh.faces.push_back(face);
    }
    if (!failed()) expect('}');
}

void ObjectParser::read_normal_indices(Mesh& mesh) {
    if (!expect('{')) return;
    const Token at = peek();
    const std::size_t count = read_count();
    if (count > mesh.faces.size()) {
        return error(at, fmt::format("expected at most {} normal indices, one for each face, before which "
                                     "`face_indices` stands",
                                     mesh.faces.size()));
    }
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        read_face_indices(mesh.faces[i].normals);
        mesh.faces[i].has_normals = true;
        accept(',');
    }
    if (!failed()) expect('}');
}

void ObjectParser::read_texture_list(Mesh& mesh) {
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
