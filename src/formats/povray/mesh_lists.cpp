// SPDX-License-Identifier: Apache-2.0
// The lists of mesh2: vectors and indices. Each is one token (number_list.h) or, with names or expressions in
// it, many.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/object_parser.h"

namespace glint::povray {

// False after an error.
bool ObjectParser::open_list() {
    list_ = NumberList();
    if (!expect('{')) return false;
    if (peek().kind != TokenKind::list) return true;
    list_at_ = take();
    std::string_view text;
    if (!list_text(list_at_, text)) return false;
    list_ = NumberList(text);
    return true;
}

void ObjectParser::close_list() {
    if (failed()) return;
    if (list_.at_end()) {
        expect('}');
    } else {
        list_error("`}`");
    }
    list_ = NumberList();
}

// An error at the next item of the list.
void ObjectParser::list_error(std::string_view wanted) {
    Token at = list_at_;
    at.kind = TokenKind::symbol;
    at.offset += static_cast<std::uint32_t>(list_.offset());
    error(at, fmt::format("expected {}, found {}", wanted, list_.is_vector() ? "a vector" : "a number"));
}

double ObjectParser::list_number() {
    if (list_.at_end()) {
        const double value = number();
        accept(',');
        return value;
    }
    if (!list_.is_vector()) return list_.number();
    list_error("a number");
    return 0;
}

// A single number fills a vector.
Vec3 ObjectParser::list_vector() {
    if (list_.at_end()) {
        const Vec3 value = vector();
        accept(',');
        return value;
    }
    if (list_.is_vector()) {
        bool is_short = false;
        return list_.vector(is_short);
    }
    const double x = list_.number();
    return {x, x, x};
}

// The number of items of a list.
std::size_t ObjectParser::read_count() {
    const Token at = list_.at_end() ? peek() : list_at_;
    const double count = list_number();
    if (!failed() && !(count >= 0 && count <= 1e9)) error(at, "expected a number of items from 0 to 1e9");
    return failed() ? 0 : static_cast<std::size_t>(count);
}

// Memory is reserved for what the text can hold.
std::size_t ObjectParser::room_for(std::size_t count) const {
    constexpr std::size_t k_least_item = 8;  // bytes: "<0,1,2>,"
    const std::size_t in_list = list_.at_end() ? 0 : list_at_.name / k_least_item + 1;
    return std::min(count, std::max<std::size_t>(in_list, 1u << 10));
}

// Vectors, each as `convert` makes it. noting: the mesh whose vertices they are.
CountedVector<Float3> ObjectParser::read_points(Float3 (*convert)(Vec3), ReadMesh* noting) {
    CountedVector<Float3> points;
    if (!open_list()) return points;
    const std::size_t count = read_count();
    points.reserve(room_for(count));
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        const Vec3 v = list_vector();
        if (noting != nullptr) noting->note_if_far(i, v);
        points.push_back(convert(v));
    }
    close_list();
    return points;
}

// <u, v>; a single number is both.
Vec3 ObjectParser::uv_vector() {
    const Numbers uv = promoted(expression(), 2);
    return {uv.v[0], uv.v[1], 0};
}

CountedVector<Float3> ObjectParser::read_uv() {
    CountedVector<Float3> points;
    if (!open_list()) return points;
    const std::size_t count = read_count();
    points.reserve(room_for(count));
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        if (list_.at_end()) {
            points.push_back(ReadMesh::stored_uv(uv_vector()));
            accept(',');
        } else {
            points.push_back(ReadMesh::stored_uv(list_vector()));
        }
    }
    close_list();
    return points;
}

std::uint32_t ObjectParser::index_of(double value, const Token& at) {
    if (!failed() && !(value >= 0 && value <= 4e9)) error(at, "expected an index from 0 to 4e9");
    return failed() ? 0 : static_cast<std::uint32_t>(value);
}

void ObjectParser::read_face_indices(TriangleCorners& indices) {
    if (!list_.at_end()) {
        if (!list_.is_vector()) return list_error("`<`");
        bool is_short = false;
        const Vec3 v = list_.vector(is_short);
        if (is_short) return error(list_at_, "expected three indices between `<` and `>`");
        indices = {index_of(v.x, list_at_), index_of(v.y, list_at_), index_of(v.z, list_at_)};
        return;
    }
    if (!expect('<')) return;
    for (std::uint32_t& index : indices) {
        const Token at = peek();
        index = index_of(number(), at);
        accept(',');
    }
    expect('>');
    accept(',');
}

void ObjectParser::read_faces(ReadMesh& mesh) {
    if (!open_list()) return;
    const std::size_t count = read_count();
    mesh.triangles.reserve(room_for(count));
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        TriangleCorners vertices{}, textures{};
        read_face_indices(vertices);
        // One texture for the face, or one for each vertex.
        std::size_t found = 0;
        const auto begins_index = [&] {
            return list_.at_end() ? !peek().is('<') && begins_number(peek()) : !list_.is_vector();
        };
        while (!failed() && found < 3 && begins_index()) {
            const Token at = list_.at_end() ? peek() : list_at_;
            textures[found++] = index_of(list_number(), at);
        }
        if (found == 1) textures[1] = textures[2] = textures[0];
        if (found == 2 && !failed()) {
            if (list_.at_end()) {
                expected("a third texture of the face");
            } else {
                list_error("a third texture of the face");
            }
        }
        if (found > 0) {
            if (mesh.texture_corners.empty()) mesh.texture_corners.reserve(room_for(count));
            ReadMesh::set(mesh.texture_corners, mesh.triangles.size(), textures);
        }
        mesh.triangles.push_back(vertices);
    }
    close_list();
}

// The numbers of a mesh's normals or uv_vectors at the corners of its faces.
void ObjectParser::read_corner_indices(CountedVector<TriangleCorners>& corners, std::size_t faces) {
    if (!open_list()) return;
    const Token at = list_.at_end() ? peek() : list_at_;
    const std::size_t count = read_count();
    if (count > faces) {
        return error(at, fmt::format("expected at most {} triples of indices, one for each face, before "
                                     "which `face_indices` stands",
                                     faces));
    }
    corners.reserve(room_for(count));
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        TriangleCorners numbers{};
        read_face_indices(numbers);
        ReadMesh::set(corners, i, numbers);
    }
    close_list();
}

}  // namespace glint::povray
