// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_mesh.h"

#include <algorithm>
#include <cmath>

#include "formats/mesh_file.h"

namespace glint {
namespace {

constexpr Range k_vertex{0, 4294967294.0, false, false, "a whole number from 0 to 4294967294"};
constexpr Range k_value{-1, 4294967294.0, false, false, "a whole number from 0 to 4294967294, or -1"};

}  // namespace

bool MeshText::read_key(int field, const Token& key) {
    if (field == 0) {
        const Token name = t_.p.token();
        if (name.kind != TokenKind::string) {
            t_.p.expected("the name of a file in quotes");
            return false;
        }
        t_.p.take();
        file_ = name;
        return true;
    }
    has_lists_ = true;
    (void)key;
    switch (field) {
        case 1:
            return read_points(mesh_.positions);
        case 2:
            return read_corners(mesh_.triangles, false);
        case 3:
            return read_values(mesh_.normals.values);
        case 4:
            return read_corners(mesh_.normals.corners, true);
        case 5:
            return read_values(mesh_.colors.values);
        case 6:
            return read_corners(mesh_.colors.corners, true);
        case 7:
            return read_pairs(mesh_.texture_coordinates.values);
        default:
            return read_corners(mesh_.texture_coordinates.corners, true);
    }
}

bool MeshText::read_points(std::vector<Vec3>& points) {
    points.clear();
    return read_list(t_, "points `(x, y, z)`", [&] {
        Vec3 p;
        if (!read_point(t_, p)) return false;
        points.push_back(p);
        return true;
    });
}

bool MeshText::read_values(std::vector<Float3>& values) {
    std::vector<Vec3> points;
    if (!read_points(points)) return false;
    values.clear();
    for (const Vec3& p : points) values.push_back(to_single(p));
    return true;
}

bool MeshText::read_pairs(std::vector<Float3>& values) {
    values.clear();
    return read_list(t_, "pairs `(u, v)`", [&] {
        double pair[2] = {};
        if (!t_.p.numbers(pair, k_coordinate, '(', ')')) return false;
        values.push_back(to_single({pair[0], pair[1], 0}));
        return true;
    });
}

bool MeshText::read_corners(std::vector<TriangleCorners>& corners, bool may_be_none) {
    corners.clear();
    const Range& range = may_be_none ? k_value : k_vertex;
    return read_list(t_, "triangles `(a, b, c)` of whole numbers", [&] {
        double numbers[3] = {};
        const Token at = t_.p.token();
        if (!t_.p.triple(numbers, range, '(', ')')) return false;
        TriangleCorners triangle{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::floor(numbers[i]) != numbers[i])
                t_.p.error(at, fmt::format("expected whole numbers, found {}", numbers[i]));
            triangle[i] = numbers[i] < 0 ? CornerValues::k_none : static_cast<std::uint32_t>(numbers[i]);
        }
        corners.push_back(triangle);
        return true;
    });
}

std::optional<std::uint32_t> MeshText::mesh_index(const Token& word) {
    if (file_ && has_lists_) {
        t_.p.error(word, "expected a mesh of a file or of lists, found both");
        return std::nullopt;
    }
    if (file_) {
        return mesh_of_file(t_.reading, t_.text, *file_, std::string(t_.p.name(*file_)));
    }
    if (!has_lists_ || mesh_.positions.empty() || mesh_.triangles.empty()) {
        t_.p.error(word, "expected a mesh's `file`, or its `vertices` and `triangles`");
        return std::nullopt;
    }
    const bool is_single = std::all_of(mesh_.positions.begin(), mesh_.positions.end(),
                                       [](const Vec3& p) { return to_vec3(to_single(p)) == p; });
    if (is_single) {
        for (const Vec3& p : mesh_.positions) mesh_.single_positions.push_back(to_single(p));
        mesh_.positions = {};
    }
    t_.scene.meshes.push_back(std::make_shared<const MeshData>(std::move(mesh_)));
    return static_cast<std::uint32_t>(t_.scene.meshes.size() - 1);
}

}  // namespace glint
