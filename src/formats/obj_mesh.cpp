// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "formats/obj_data.h"

namespace glint {

std::uint32_t ObjMeshes::Used::number_of(std::uint32_t in_file) {
    std::uint32_t& number = numbers[in_file];
    if (number == CornerValues::k_none) {
        number = static_cast<std::uint32_t>(order.size());
        order.push_back(in_file);
    }
    return number;
}

// Takes the time of what was used, as files may have many small parts.
void ObjMeshes::Used::clear() {
    for (const std::uint32_t in_file : order) numbers[in_file] = CornerValues::k_none;
    order.clear();
}

bool ObjMeshes::has_room(const ObjPart& part) {
    const std::uint64_t vertices = std::min(3 * part.triangles.size(), data_.positions.size());
    const std::uint64_t colors = data_.vertex_colors.empty() ? 0 : vertices;
    const std::uint64_t normals = std::min(3 * part.normals.size(), data_.normals.size());
    const std::uint64_t textures = std::min(3 * part.textures.size(), data_.texture_coordinates.size());
    const std::uint64_t corners =
        (2 + !part.normals.empty() + !part.textures.empty()) * std::uint64_t{part.triangles.size()};
    const std::uint64_t bytes = MemoryBudget::list_bytes(corners, sizeof(TriangleCorners)) +
                                MemoryBudget::list_bytes(vertices, sizeof(Vec3) + sizeof(std::uint32_t)) +
                                MemoryBudget::list_bytes(colors + 2 * (normals + textures), sizeof(Float3));
    return reading_.has_room(bytes, where_, 0);
}

std::shared_ptr<const MeshData> ObjMeshes::make(ObjPart& part) {
    if (!has_room(part)) return nullptr;
    auto mesh = std::make_shared<MeshData>();
    vertices_.numbers.resize(data_.positions.size(), CornerValues::k_none);
    mesh->triangles.reserve(part.triangles.size());
    for (const TriangleCorners& t : part.triangles)
        mesh->triangles.push_back(
            {vertices_.number_of(t[0]), vertices_.number_of(t[1]), vertices_.number_of(t[2])});
    const CountedVector<std::uint32_t>& used = vertices_.order;
    if (data_.is_single) {
        mesh->single_positions.reserve(used.size());
        for (const std::uint32_t v : used) {
            const Vec3& p = data_.positions[v];
            mesh->single_positions.push_back(
                {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        }
    } else {
        mesh->positions.reserve(used.size());
        for (const std::uint32_t v : used) mesh->positions.push_back(data_.positions[v]);
    }
    add_values(part.normals, data_.normals, normals_, *mesh, mesh->normals);
    add_values(part.textures, data_.texture_coordinates, textures_, *mesh, mesh->texture_coordinates);
    add_colors(part, *mesh);
    vertices_.clear();
    normals_.clear();
    textures_.clear();
    part.triangles = part.normals = part.textures = {};
    return mesh;
}

// part: by triangle, numbers in `all`, or k_none first for a triangle without values.
void ObjMeshes::add_values(const CountedVector<TriangleCorners>& part, const CountedVector<Float3>& all,
                           Used& used, const MeshData& mesh, CornerValues& values) {
    constexpr TriangleCorners none{CornerValues::k_none, CornerValues::k_none, CornerValues::k_none};
    const auto has_values = [](const TriangleCorners& n) { return n[0] != CornerValues::k_none; };
    if (std::none_of(part.begin(), part.end(), has_values)) return;
    used.numbers.resize(all.size(), CornerValues::k_none);
    std::vector<TriangleCorners>& corners = values.corners;
    corners.reserve(mesh.triangles.size());
    for (const TriangleCorners& n : part)
        corners.push_back(
            has_values(n) ? TriangleCorners{used.number_of(n[0]), used.number_of(n[1]), used.number_of(n[2])}
                          : none);
    corners.resize(mesh.triangles.size(), none);
    values.values.reserve(used.order.size());
    for (const std::uint32_t n : used.order) values.values.push_back(all[n]);
    // Files that number them as vertices need no second list.
    if (values.values.size() == mesh.vertex_count() && corners == mesh.triangles) corners = {};
}

// A triangle has colors if all of its vertices do.
void ObjMeshes::add_colors(const ObjPart& part, MeshData& mesh) {
    const CountedVector<std::uint32_t>& used = vertices_.order;
    const auto has_color = [&](std::uint32_t v) { return data_.has_color(v); };
    if (std::none_of(used.begin(), used.end(), has_color)) return;
    mesh.colors.values.reserve(used.size());
    for (const std::uint32_t v : used)
        mesh.colors.values.push_back(has_color(v) ? data_.vertex_colors[v] : Float3{});
    if (std::all_of(used.begin(), used.end(), has_color)) return;
    mesh.colors.corners = mesh.triangles;
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
        if (!std::all_of(part.triangles[i].begin(), part.triangles[i].end(), has_color))
            mesh.colors.corners[i].fill(CornerValues::k_none);
    }
}

}  // namespace glint
