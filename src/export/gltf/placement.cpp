// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/placement.h"

#include <algorithm>

#include "math/number.h"
#include "math/transform.h"

namespace glint::gltf_export {
namespace {

// Programs decompose a matrix in single precision, with an absolute tolerance. With larger numbers than
// this, it is written decomposed.
constexpr double k_matrix = 100;

Vec3 column_of(const Affine& map, std::size_t c) { return {map.m[0][c], map.m[1][c], map.m[2][c]}; }

Json numbers(Vec3 v) { return {v.x, v.y, v.z}; }

bool is_diagonal(const Affine& map) {
    const auto& m = map.m;
    return m[0][1] == 0 && m[0][2] == 0 && m[1][0] == 0 && m[1][2] == 0 && m[2][0] == 0 && m[2][1] == 0;
}

double greatest_number(const Affine& map) {
    double most = 0;
    for (const auto& row : map.m)
        for (const double x : row) most = std::max(most, number::abs(x));
    return most;
}

Json matrix_of(const Affine& map) {
    Json matrix = Json::array();
    for (std::size_t column = 0; column < 4; ++column) {
        for (const auto& row : map.m) matrix.push_back(row[column]);
        matrix.push_back(column == 3 ? 1 : 0);
    }
    return matrix;
}

// The quaternion x, y, z, w of the rotation whose columns these are. Its greatest component comes from a
// square root, the others from differences and sums (Shepperd, Quaternion from Rotation Matrix, 1978).
Json quaternion_of(Vec3 x, Vec3 y, Vec3 z) {
    const double squares[4] = {1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                               1 + x.x + y.y + z.z};  // four times
    const auto i = static_cast<std::size_t>(std::max_element(squares, squares + 4) - squares);
    const double own = number::sqrt(squares[i]) / 2, over = 1 / (4 * own);
    const double differences[3] = {(y.z - z.y) * over, (z.x - x.z) * over, (x.y - y.x) * over};
    const double xy = (x.y + y.x) * over, xz = (z.x + x.z) * over, yz = (y.z + z.y) * over;
    switch (i) {
        case 0:
            return {own, xy, xz, differences[0]};
        case 1:
            return {xy, own, yz, differences[1]};
        case 2:
            return {xz, yz, own, differences[2]};
        default:
            return {differences[0], differences[1], differences[2], own};
    }
}

}  // namespace

bool is_placement(const Affine& map) {
    for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 a = normalize(column_of(map, c)), b = normalize(column_of(map, (c + 1) % 3));
        if (number::abs(dot(a, b)) > 1e-6) return false;
    }
    // In the single precision of other programs.
    return number::abs(determinant(map)) > 1e-36;
}

void add_placement(Json& node, const Affine& map) {
    const Vec3 translation = column_of(map, 3);
    if (!is_diagonal(map) && greatest_number(map) <= k_matrix) {
        node["matrix"] = matrix_of(map);
        return;
    }
    if (translation != Vec3{}) node["translation"] = numbers(translation);
    Vec3 scale{map.m[0][0], map.m[1][1], map.m[2][2]};
    if (!is_diagonal(map)) {
        const double side = determinant(map) < 0 ? -1 : 1;
        const Vec3 x = column_of(map, 0), y = column_of(map, 1), z = column_of(map, 2);
        scale = {side * length(x), length(y), length(z)};
        node["rotation"] = quaternion_of(normalize(x) * side, normalize(y), normalize(z));
    }
    if (scale != Vec3{1, 1, 1}) node["scale"] = numbers(scale);
}

}  // namespace glint::gltf_export
