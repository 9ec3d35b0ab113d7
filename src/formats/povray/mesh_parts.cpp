// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/mesh_parts.h"

#include <algorithm>
#include <limits>

#include "formats/number_table.h"
#include "scene/material_color.h"

namespace glint::povray {
namespace {

constexpr std::uint32_t k_unset = CornerValues::k_none;

bool have_same_color(const Pigment& a, const Pigment& b) { return rgb_of(a.color) == rgb_of(b.color); }

// Copies the vertices, normals and colors that some triangles of a mesh have.
class PartBuilder {
  public:
    explicit PartBuilder(const ReadMesh& mesh) : mesh_(mesh) {}

    // The whole mesh: its lists as they are.
    std::shared_ptr<MeshData> whole() const {
        auto data = std::make_shared<MeshData>();
        data->single_positions.assign(mesh_.vertices.begin(), mesh_.vertices.end());
        data->triangles.assign(mesh_.triangles.begin(), mesh_.triangles.end());
        assign(mesh_.normals, mesh_.normal_corners, data->normals);
        assign(mesh_.uv, mesh_.uv_corners, data->texture_coordinates);
        return data;
    }

    std::shared_ptr<MeshData> of(const CountedVector<std::uint32_t>& triangles) {
        auto data = std::make_shared<MeshData>();
        const auto has_normals = [&](std::uint32_t t) { return ReadMesh::has(mesh_.normal_corners, t); };
        const bool is_flat = std::none_of(triangles.begin(), triangles.end(), has_normals);
        data->triangles.reserve(triangles.size());
        for (const std::uint32_t t : triangles) {
            data->triangles.push_back(
                numbered(mesh_.triangles[t], mesh_.vertices, vertices_, data->single_positions));
            if (!is_flat) add(t, mesh_.normals, mesh_.normal_corners, normals_, data->normals);
            if (!mesh_.uv.empty()) add(t, mesh_.uv, mesh_.uv_corners, uv_, data->texture_coordinates);
        }
        vertices_.clear(), normals_.clear(), uv_.clear();
        return data;
    }

    // The colors of the triangles' textures.
    void add_colors(const CountedVector<std::uint32_t>& triangles, MeshData& data) {
        data.colors.corners.reserve(triangles.size());
        for (const std::uint32_t t : triangles) {
            TriangleCorners corners{};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t texture = mesh_.texture_corners[t][i];
                corners[i] = colors_.number_of(texture, mesh_.textures.size());
                if (corners[i] < data.colors.values.size()) continue;
                const auto& c = mesh_.textures[texture]->pigment.color;
                data.colors.values.push_back(to_single({c[0], c[1], c[2]}));
            }
            data.colors.corners.push_back(corners);
        }
        colors_.clear();
    }

  private:
    // New numbers of a list's items, in the order in which they are used.
    struct Numbering {
        CountedVector<std::uint32_t> number, used;
        std::uint32_t number_of(std::uint32_t item, std::size_t items) {
            if (number.empty()) number.resize(items, k_unset);
            if (number[item] == k_unset) {
                number[item] = static_cast<std::uint32_t>(used.size());
                used.push_back(item);
            }
            return number[item];
        }
        void clear() {
            for (const std::uint32_t item : used) number[item] = k_unset;
            used.clear();
        }
    };

    // All values of a kind.
    void assign(const CountedVector<Float3>& values, const CountedVector<TriangleCorners>& corners,
                CornerValues& to) const {
        if (corners.empty()) return;
        to.values.assign(values.begin(), values.end());
        if (values.size() == mesh_.vertices.size() && corners == mesh_.triangles) return;  // by vertex
        to.corners.assign(corners.begin(), corners.end());
        to.corners.resize(mesh_.triangles.size(), {k_unset, k_unset, k_unset});
    }
    // Those of a triangle, if it has any.
    static void add(std::uint32_t t, const CountedVector<Float3>& values,
                    const CountedVector<TriangleCorners>& corners, Numbering& numbering, CornerValues& to) {
        to.corners.push_back(ReadMesh::has(corners, t) ? numbered(corners[t], values, numbering, to.values)
                                                       : TriangleCorners{k_unset, k_unset, k_unset});
    }

    static TriangleCorners numbered(const TriangleCorners& corners, const CountedVector<Float3>& from,
                                    Numbering& numbering, std::vector<Float3>& to) {
        TriangleCorners out{};
        for (std::size_t i = 0; i < 3; ++i) {
            out[i] = numbering.number_of(corners[i], from.size());
            if (out[i] == to.size()) to.push_back(from[corners[i]]);
        }
        return out;
    }

    const ReadMesh& mesh_;
    Numbering vertices_, normals_, uv_, colors_;
};

}  // namespace

bool is_linear_in_color(const Texture& texture) {
    const Finish& f = texture.finish;
    const std::array<double, 5>& p = texture.pigment.color;
    const auto fits = [](double c) { return c >= 0 && c <= 1e6; };  // what vertex colors may be
    return f.emission == Color{0, 0, 0} && f.ambient.r == f.ambient.g && f.ambient.g == f.ambient.b &&
           p[3] == 0 && !texture.below && fits(p[0]) && fits(p[1]) && fits(p[2]);
}

Texture without_color(const Texture& texture) {
    Texture out = texture;
    out.pigment.color[0] = k_color_of_vertices.r;
    out.pigment.color[1] = k_color_of_vertices.g;
    out.pigment.color[2] = k_color_of_vertices.b;
    return out;
}

Looks::Looks(const ReadMesh& mesh) : of_(mesh.textures.size(), k_unset) {
    NumberTable<std::tuple_size_v<TextureNumbers>> known;
    for (const TriangleCorners& corners : mesh.texture_corners) {
        if (corners[0] == k_unset) continue;
        for (const std::uint32_t i : corners) {
            if (of_[i] != k_unset) continue;
            TextureNumbers numbers = numbers_of(*mesh.textures[i]);
            // No color is infinite: such textures are not taken for others.
            if (is_linear_in_color(*mesh.textures[i]))
                std::fill_n(numbers.begin(), 3, std::numeric_limits<double>::infinity());
            if (const std::uint32_t* look = known.find(numbers)) {
                of_[i] = *look;
                continue;
            }
            of_[i] = count();
            known.add(numbers, of_[i]);
            first_.push_back(i);
        }
    }
}

std::uint64_t bytes_of_parts(const ReadMesh& mesh) {
    const auto bytes = [](const auto& list, std::uint64_t item) {
        return MemoryBudget::list_bytes(list.size(), item);
    };
    // Positions, normals, uv_vectors, and the corners of each; colors; the order of the triangles, and their
    // numbers.
    return bytes(mesh.vertices, sizeof(Float3) + 4) + bytes(mesh.normals, sizeof(Float3) + 4) +
           bytes(mesh.uv, sizeof(Float3) + 4) + bytes(mesh.uv_corners, sizeof(TriangleCorners)) +
           bytes(mesh.triangles, 2 * sizeof(TriangleCorners)) +
           bytes(mesh.texture_corners, sizeof(TriangleCorners) + 8) +
           bytes(mesh.textures, sizeof(Float3) + 16);
}

MeshParts mesh_parts(const ReadMesh& mesh) {
    MeshParts out;
    if (mesh.triangles.empty()) return out;
    PartBuilder builder(mesh);
    if (mesh.texture_corners.empty()) {
        out.parts.push_back({builder.whole(), nullptr});
        return out;
    }
    const Looks looks(mesh);
    // The triangles by look; those without a texture come last.
    const std::uint32_t none = looks.count();
    CountedVector<CountedVector<std::uint32_t>> triangles(std::size_t{none} + 1);
    CountedVector<std::uint8_t> has_colors(none);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!ReadMesh::has(mesh.texture_corners, t)) {
            triangles[none].push_back(t);
            continue;
        }
        const TriangleCorners& textures = mesh.texture_corners[t];
        const std::uint32_t look = looks.of(textures[0]);
        if (looks.of(textures[1]) != look || looks.of(textures[2]) != look) {
            out.blended.push_back(t);
            continue;
        }
        triangles[look].push_back(t);
        const Pigment& first = mesh.textures[looks.first(look)]->pigment;
        for (const std::uint32_t i : textures)
            if (!have_same_color(mesh.textures[i]->pigment, first)) has_colors[look] = 1;
    }
    for (std::uint32_t look = 0; look <= none; ++look) {
        const CountedVector<std::uint32_t>& own = triangles[look];
        if (own.empty()) continue;
        const std::shared_ptr<MeshData> data =
            own.size() == mesh.triangles.size() ? builder.whole() : builder.of(own);
        MeshPart part{data, look == none ? nullptr : mesh.textures[looks.first(look)]};
        if (look != none && has_colors[look] != 0) {
            builder.add_colors(own, *data);
            part.texture = make_counted<const Texture>(without_color(*part.texture));
        }
        out.parts.push_back(std::move(part));
    }
    for (std::uint32_t i = 0; i < mesh.textures.size(); ++i) {
        if (looks.of(i) != k_unset && has_warnings(*mesh.textures[i])) out.warned.push_back(mesh.textures[i]);
    }
    return out;
}

}  // namespace glint::povray
