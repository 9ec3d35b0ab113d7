// SPDX-License-Identifier: Apache-2.0
// Smooth triangles of meshes whose transform gives their normals different lengths.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/add_shape.h"
#include "formats/povray/parts.h"
#include "math/number.h"

namespace glint::povray {
namespace {

constexpr double k_angle = 0.0005;  // radians: the greatest error of a normal that is not seen
constexpr int k_max_smooth_parts = 16;

// The sine of the angle between the mean of the normals as given and that of their unit vectors.
double apart(const Vec3 (&n)[3], const CornerWeights& w) {
    const Vec3 given = mixed(n[0], n[1], n[2], w);
    const Vec3 unit = mixed(normalize(n[0]), normalize(n[1]), normalize(n[2]), w);
    const double size = length(given) * length(unit);
    const double sine = size > 0 ? length(cross(given, unit)) / size : 0;
    return sine <= 1 ? sine : 1;  // also of numbers that are too large
}

// The number of parts of a side with which the error is small: it decreases with the square of the number.
int part_count(const Vec3 (&n)[3]) {
    const double a = dot(n[0], n[0]), b = dot(n[1], n[1]), c = dot(n[2], n[2]);
    if (std::max({a, b, c}) <= 1.001 * std::min({a, b, c})) return 1;
    const double most = std::max({apart(n, {1.0 / 3, 1.0 / 3, 1.0 / 3}), apart(n, {0.5, 0.5, 0}),
                                  apart(n, {0.5, 0, 0.5}), apart(n, {0, 0.5, 0.5})});
    return std::clamp(static_cast<int>(number::sqrt(most / k_angle)) + 1, 1, k_max_smooth_parts);
}

}  // namespace

bool has_normals_on_both_sides(const std::array<Vec3, 3>& vertices, const std::array<Vec3, 3>& normals) {
    const Vec3 face = cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
    bool front = false, back = false;
    for (const Vec3& n : normals) {
        front = front || dot(n, face) > 0;
        back = back || dot(n, face) < 0;
    }
    return front && back;
}

// POV-Ray mixes the three normals in the mesh's space, glint the unit vectors after the transform. In small
// parts of the triangle, whose normals have nearly the same length, both are the same.
void SceneBuilder::add_smooth(const SmoothTriangle& whole, std::uint32_t material, const Token& at) {
    const int n = part_count(whole.normals);
    if (n == 1) return add(whole, material, nullptr, at);
    if (!stream_.count_shapes(static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n)))
        return stream_.error(at, fmt::format("more than {} shapes", stream_.max_shapes()));
    for_each_part(n, [&](const std::array<CornerWeights, 3>& corners) {
        SmoothTriangle part;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& v = whole.vertices;
            const auto& m = whole.normals;
            part.vertices[k] = mixed(v[0], v[1], v[2], corners[k]);
            part.normals[k] = mixed(m[0], m[1], m[2], corners[k]);
        }
        add(part, material, nullptr, at);
        return !stream_.failed();
    });
}

}  // namespace glint::povray
