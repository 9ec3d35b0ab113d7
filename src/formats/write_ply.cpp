// SPDX-License-Identifier: Apache-2.0
// Writes a mesh as a binary .ply file.
#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <iterator>
#include <utility>

#include "base/status.h"
#include "formats/single_vertices.h"
#include "glint/write.h"
#include "scene/validate_mesh.h"

namespace glint {
namespace {

// A file has one list of vertices: those that differ in one of these are several.
class PlyWriter {
  public:
    explicit PlyWriter(const MeshData& mesh) : mesh_(mesh), single_(single_vertices(mesh)) {}

    std::string run() {
        write_header();
        for (const SingleVertex& vertex : single_.vertices) write_vertex(vertex);
        for (const TriangleCorners& triangle : single_.triangles) {
            out_ += '\3';
            for (const std::uint32_t corner : triangle) append(corner);
        }
        return std::move(out_);
    }

  private:
    void write_header() {
        const std::string_view type = mesh_.single_positions.empty() ? "double" : "float";
        fmt::format_to(std::back_inserter(out_),
                       "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty {} x\nproperty {} "
                       "y\nproperty {} z\n",
                       single_.vertices.size(), type, type, type);
        if (!mesh_.normals.empty()) out_ += "property float nx\nproperty float ny\nproperty float nz\n";
        if (!mesh_.colors.empty()) out_ += "property float red\nproperty float green\nproperty float blue\n";
        if (!mesh_.texture_coordinates.empty()) out_ += "property float s\nproperty float t\n";
        fmt::format_to(std::back_inserter(out_),
                       "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
                       single_.triangles.size());
    }

    void write_vertex(const SingleVertex& vertex) {
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
    const SingleVertices single_;
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
