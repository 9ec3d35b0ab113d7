// SPDX-License-Identifier: Apache-2.0
// Tachyon's triangles. Those of vertex arrays, and those with vertex colors, become meshes.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "formats/tachyon_reader.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/material_color.h"

namespace glint {
namespace {

constexpr std::uint32_t k_no_number = CornerValues::k_none;

// Glint interpolates unit normals. One of 0 makes its triangles flat.
Float3 single_normal(const Vec3& n) {
    const double most = number::max(number::max(number::abs(n.x), number::abs(n.y)), number::abs(n.z));
    return most > 0 ? to_single(normalize(n / most)) : Float3{};
}

Float3 single_color(const Color& c) {
    return to_single({number::max(c.r, 0.0), number::max(c.g, 0.0), number::max(c.b, 0.0)});
}

}  // namespace

double tachyon_spread(const double (&numbers)[3]) {
    return number::max(number::max(numbers[0], numbers[1]), numbers[2]) /
           number::min(number::min(numbers[0], numbers[1]), numbers[2]);
}

// What glint does otherwise with normals of this triangle.
void TachyonReader::note_normals(const Vec3 (&n)[3]) {
    if (is_zero(n[0]) || is_zero(n[1]) || is_zero(n[2])) {
        // It would have no light at such a vertex.
        reading_.diagnostics.warn_once(
            "tachyon normal", text_.place, object_.offset, object_.length,
            "a vertex has the normal 0 0 0: triangles with such a vertex are drawn flat");
        return;
    }
    const double squares[] = {dot(n[0], n[0]), dot(n[1], n[1]), dot(n[2], n[2])};
    if (tachyon_spread(squares) > 1.04) note_limit(TachyonLimit::normal_lengths, object_);  // by more than 2%
}

void TachyonReader::add_smooth(const SmoothTriangle& t, std::uint32_t material) {
    const auto& n = t.normals;
    note_normals(n);
    if (is_zero(n[0]) || is_zero(n[1]) || is_zero(n[2]))
        return add(Triangle{{t.vertices[0], t.vertices[1], t.vertices[2]}}, material);
    add(t, material);
}

bool TachyonReader::read_triangle() {
    Triangle t;
    std::uint32_t material = k_none;
    if (!point("V0", "V0", t.vertices[0]) || !point("V1", "V1", t.vertices[1]) ||
        !point("V2", "V2", t.vertices[2]) || !texture(material)) {
        return false;
    }
    add(t, material);
    return true;
}

bool TachyonReader::read_smooth_triangle() {
    SmoothTriangle t;
    std::uint32_t material = k_none;
    if (!point("V0", "V0", t.vertices[0]) || !point("V1", "V1", t.vertices[1]) ||
        !point("V2", "V2", t.vertices[2]) || !point("N0", "N0", t.normals[0]) ||
        !point("N1", "N1", t.normals[1]) || !point("N2", "N2", t.normals[2]) || !texture(material)) {
        return false;
    }
    add_smooth(t, material);
    return true;
}

// Into the mesh of those before it that have the same material, whose place it has then: programs write one
// for each triangle of a surface.
void TachyonReader::gather(const SmoothTriangle& t, const Color (&colors)[3], std::uint32_t material) {
    if (!gathered_ || gathered_material_ != material) {
        gathered_ = std::make_shared<MeshData>();
        gathered_material_ = material;
        reading_.memory.set_growing(gathered_);
        scene_.meshes.push_back(gathered_);
        add(Mesh{static_cast<std::uint32_t>(scene_.meshes.size() - 1)}, material);
    }
    note_normals(t.normals);
    const auto first = static_cast<std::uint32_t>(gathered_->positions.size());
    for (std::size_t i = 0; i < 3; ++i) {
        gathered_->positions.push_back(t.vertices[i]);
        gathered_->normals.values.push_back(single_normal(t.normals[i]));
        gathered_->colors.values.push_back(single_color(colors[i]));
    }
    gathered_->triangles.push_back({first, first + 1, first + 2});
    if (gathered_->triangles.size() % 4096 == 0) reading_.memory.count(scene_);
}

bool TachyonReader::read_colored_triangle() {
    SmoothTriangle t;
    Color c[3];
    if (!point("V0", "V0", t.vertices[0]) || !point("V1", "V1", t.vertices[1]) ||
        !point("V2", "V2", t.vertices[2]) || !point("N0", "N0", t.normals[0]) ||
        !point("N1", "N1", t.normals[1]) || !point("N2", "N2", t.normals[2]) || !color("C0", "C0", c[0]) ||
        !color("C1", "C1", c[1]) || !color("C2", "C2", c[2])) {
        return false;
    }
    scanner_.accept("TEXTURE");
    TachyonTexture read;
    if (!texture_body(read, true)) return false;
    read.color = k_color_of_vertices;
    gather(t, c, material_of(read, object_));
    return true;
}

bool TachyonReader::read_vertices() {
    double count = 0;
    if (!expect("NUMVERTS", "Numverts") || !whole_number(count, k_tachyon_count)) return false;
    const auto read_points = [&](CountedVector<Vec3>& list) {
        list.clear();
        const std::size_t most = scanner_.at_most(count);
        if (reading_.memory.has_room(MemoryBudget::list_bytes(most, sizeof(Vec3)))) list.reserve(most);
        for (double left = count; left > 0; --left) {
            Vec3 v;
            if (!point(v) || !go_on()) return false;
            list.push_back(v);
        }
        return true;
    };
    if (!expect("COORDS", "Coords") || !read_points(coordinates_) || !expect("NORMALS", "Normals") ||
        !read_points(normals_)) {
        return false;
    }
    colors_.clear();
    facets_.clear();
    vertex_texture_ = {};
    while (!scanner_.accept("END_VERTEXARRAY")) {
        if (scanner_.accept("COLORS")) {
            if (!add_facets()) return false;
            colors_.clear();
            for (double left = count; left > 0; --left) {
                Color c;
                if (!color(c) || !go_on()) return false;
                colors_.push_back(c);
            }
        } else if (scanner_.accept("TEXTURE")) {
            if (!add_facets()) return false;
            vertex_texture_ = {};
            if (!texture_body(vertex_texture_, false)) return false;
        } else if (scanner_.accept("TRIMESH") ? !read_facets(false)
                   : scanner_.accept("TRISTRIP")
                       ? !read_facets(true)
                       : !expected("`Colors`, `Texture`, `TriMesh`, `TriStrip` or `End_VertexArray`")) {
            add_facets();
            return false;
        }
        if (reading_.diagnostics.full()) return false;
    }
    return add_facets();
}

// The facets that have been read, with the texture and the colors before them, as a mesh.
bool TachyonReader::add_facets() {
    if (facets_.empty()) return true;
    const bool has_colors = !colors_.empty();
    TachyonTexture texture = vertex_texture_;
    if (has_colors) {
        texture.color = k_color_of_vertices;
        texture.function = TachyonFunction::none;  // has no effect in Tachyon
        texture.center = {};
    }
    const std::uint32_t material = material_of(texture, object_);
    for (const TriangleCorners& f : facets_) note_normals({normals_[f[0]], normals_[f[1]], normals_[f[2]]});
    constexpr std::uint64_t k_vertex_bytes = sizeof(Vec3) + 2 * sizeof(Float3);
    const std::size_t most = std::min(coordinates_.size(), 3 * facets_.size());
    const std::uint64_t bytes = MemoryBudget::list_bytes(most, k_vertex_bytes) +
                                MemoryBudget::list_bytes(facets_.size(), sizeof(TriangleCorners));
    if (!reading_.has_room(bytes, text_.place, object_.offset, object_.length)) return false;
    auto mesh = std::make_shared<MeshData>();
    mesh->triangles.reserve(facets_.size());
    vertex_numbers_.resize(coordinates_.size(), k_no_number);
    for (TriangleCorners f : facets_) {
        for (std::uint32_t& vertex : f) {
            std::uint32_t& number = vertex_numbers_[vertex];
            if (number == k_no_number) {
                number = static_cast<std::uint32_t>(mesh->positions.size());
                mesh->positions.push_back(coordinates_[vertex]);
                mesh->normals.values.push_back(single_normal(normals_[vertex]));
                if (has_colors) mesh->colors.values.push_back(single_color(colors_[vertex]));
            }
            vertex = number;
        }
        mesh->triangles.push_back(f);
    }
    for (const TriangleCorners& f : facets_)
        for (const std::uint32_t vertex : f) vertex_numbers_[vertex] = k_no_number;
    facets_.clear();
    scene_.meshes.push_back(std::move(mesh));
    add(Mesh{static_cast<std::uint32_t>(scene_.meshes.size() - 1)}, material);
    return reading_.is_within_memory(text_.place, object_.offset, object_.length);
}

// The triangles of a mesh: three indices each. Of a strip: each index makes one with the two before it.
bool TachyonReader::read_facets(bool is_strip) {
    const Range index_range{0, number::max(0.0, static_cast<double>(coordinates_.size()) - 1), false, false,
                            "the index of a vertex, from 0"};
    double count = 0;
    if (!whole_number(count, k_tachyon_count)) return false;
    std::uint32_t a = 0, b = 0, c = 0;
    const auto read_corner = [&](std::uint32_t& corner) {
        double index = 0;
        if (coordinates_.empty()) return expected("a vertex array that has vertices");
        if (!whole_number(index, index_range)) return false;
        corner = static_cast<std::uint32_t>(index);
        return true;
    };
    if (!is_strip) {
        const std::size_t most = facets_.size() + scanner_.at_most(count);
        if (reading_.memory.has_room(MemoryBudget::list_bytes(most, sizeof(TriangleCorners))))
            facets_.reserve(most);
        for (double left = count; left > 0; --left) {
            if (!read_corner(a) || !read_corner(b) || !read_corner(c) || !go_on()) return false;
            facets_.push_back({a, b, c});
        }
        return true;
    }
    for (double k = 0; k < count; ++k) {
        a = b;
        b = c;
        if (!read_corner(c) || !go_on()) return false;
        if (k < 2) continue;
        // Every second one is turned.
        if (static_cast<std::uint64_t>(k) % 2 != 0) {
            facets_.push_back({b, a, c});
        } else {
            facets_.push_back({a, b, c});
        }
    }
    return true;
}

}  // namespace glint
