// SPDX-License-Identifier: Apache-2.0
// Writes a mesh as a binary .ply file.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "base/status.h"
#include "glint/write.h"
#include "scene/validate_mesh.h"

namespace glint {
namespace {

// What a vertex of the file has: the numbers of its position, normal, color and texture coordinates.
using Vertex = std::array<std::uint32_t, 4>;

// A file has one list of vertices: those that differ in one of these are several.
class PlyWriter {
  public:
    explicit PlyWriter(const MeshData& mesh) : mesh_(mesh) {}

    std::string run() {
        number_vertices();
        write_header();
        for (const Vertex& vertex : vertices_) write_vertex(vertex);
        for (const TriangleCorners& triangle : triangles_) {
            out_ += '\3';
            for (const std::uint32_t corner : triangle) append(corner);
        }
        return std::move(out_);
    }

  private:
    void number_vertices() {
        if (mesh_.normals.corners.empty() && mesh_.colors.corners.empty() &&
            mesh_.texture_coordinates.corners.empty()) {
            for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) vertices_.push_back({v, v, v, v});
            triangles_ = mesh_.triangles;
            return;
        }
        std::map<Vertex, std::uint32_t> numbers;
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
            TriangleCorners triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vertex vertex{mesh_.triangles[i][k], number_of(mesh_.normals, i, k),
                                    number_of(mesh_.colors, i, k),
                                    number_of(mesh_.texture_coordinates, i, k)};
                const auto [at, is_new] =
                    numbers.emplace(vertex, static_cast<std::uint32_t>(vertices_.size()));
                if (is_new) vertices_.push_back(vertex);
                triangle[k] = at->second;
            }
            triangles_.push_back(triangle);
        }
    }
    std::uint32_t number_of(const CornerValues& of, std::size_t triangle, std::size_t corner) const {
        if (of.empty()) return CornerValues::k_none;
        return (of.corners.empty() ? mesh_.triangles : of.corners)[triangle][corner];
    }

    void write_header() {
        const std::string_view type = mesh_.single_positions.empty() ? "double" : "float";
        fmt::format_to(std::back_inserter(out_),
                       "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty {} x\nproperty {} "
                       "y\nproperty {} z\n",
                       vertices_.size(), type, type, type);
        if (!mesh_.normals.empty()) out_ += "property float nx\nproperty float ny\nproperty float nz\n";
        if (!mesh_.colors.empty()) out_ += "property float red\nproperty float green\nproperty float blue\n";
        if (!mesh_.texture_coordinates.empty()) out_ += "property float s\nproperty float t\n";
        fmt::format_to(std::back_inserter(out_),
                       "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
                       triangles_.size());
    }

    void write_vertex(const Vertex& vertex) {
        if (mesh_.single_positions.empty()) {
            const Vec3 p = mesh_.position(vertex[0]);
            append(p.x), append(p.y), append(p.z);
        } else {
            append(mesh_.single_positions[vertex[0]]);
        }
        append(mesh_.normals, vertex[1]);
        append(mesh_.colors, vertex[2]);
        if (mesh_.texture_coordinates.empty()) return;
        const Float3& uv = mesh_.texture_coordinates.values[vertex[3]];
        append(uv.x), append(uv.y);
    }
    void append(const CornerValues& of, std::uint32_t number) {
        if (!of.empty()) append(number < of.values.size() ? of.values[number] : Float3{});
    }
    void append(const Float3& f) { append(f.x), append(f.y), append(f.z); }
    template <class Number> void append(Number number) {
        static_assert(std::endian::native == std::endian::little);
        char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        out_.append(bytes, sizeof number);
    }

    const MeshData& mesh_;
    std::vector<Vertex> vertices_;
    std::vector<TriangleCorners> triangles_;
    std::string out_;
};

// Whether some triangles have values and others have none.
bool has_gaps(const MeshData& mesh, const CornerValues& of) {
    if (of.empty()) return false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!mesh.corner_values(of, i)) return true;
    }
    return false;
}

}  // namespace

Result<std::string> write_ply(const MeshData& mesh) {
    const auto body = [&]() -> Result<std::string> {
        if (std::string mistake = mistake_in(mesh); !mistake.empty())
            return Status{ErrorCode::invalid_argument, std::move(mistake), {}};
        for (const auto& [of, what] :
             {std::pair{&mesh.colors, "colors"}, {&mesh.texture_coordinates, "texture coordinates"}}) {
            if (has_gaps(mesh, *of))
                return Status{ErrorCode::invalid_argument,
                              fmt::format("a .ply file cannot have triangles without {} beside others", what),
                              {}};
        }
        return PlyWriter(mesh).run();
    };
    return result_of(body, " while writing the mesh");
}

}  // namespace glint
