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
    const std::uint64_t corners =
        2 * part.triangles.size() + (part.normals.empty() ? 0 : part.triangles.size());
    const std::uint64_t bytes = MemoryBudget::list_bytes(corners, sizeof(TriangleCorners)) +
                                MemoryBudget::list_bytes(vertices, sizeof(Vec3) + sizeof(std::uint32_t)) +
                                MemoryBudget::list_bytes(colors + 2 * normals, sizeof(Float3));
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
    add_normals(part, *mesh);
    add_colors(part, *mesh);
    vertices_.clear();
    normals_.clear();
    part.triangles = part.normals = {};
    return mesh;
}

void ObjMeshes::add_normals(const ObjPart& part, MeshData& mesh) {
    constexpr TriangleCorners none{CornerValues::k_none, CornerValues::k_none, CornerValues::k_none};
    const auto has_normals = [](const TriangleCorners& n) { return n[0] != CornerValues::k_none; };
    if (std::none_of(part.normals.begin(), part.normals.end(), has_normals)) return;
    normals_.numbers.resize(data_.normals.size(), CornerValues::k_none);
    std::vector<TriangleCorners>& corners = mesh.normals.corners;
    corners.reserve(part.triangles.size());
    for (const TriangleCorners& n : part.normals)
        corners.push_back(has_normals(n) ? TriangleCorners{normals_.number_of(n[0]), normals_.number_of(n[1]),
                                                           normals_.number_of(n[2])}
                                         : none);
    corners.resize(part.triangles.size(), none);
    mesh.normals.values.reserve(normals_.order.size());
    for (const std::uint32_t n : normals_.order) mesh.normals.values.push_back(data_.normals[n]);
    // Files that number normals as vertices need no second list.
    if (mesh.normals.values.size() == mesh.vertex_count() && corners == mesh.triangles) corners = {};
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
