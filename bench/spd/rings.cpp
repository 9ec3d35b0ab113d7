// SPDX-License-Identifier: Apache-2.0
// A pyramid of objects, each of six pentagonal rings arranged like a dodecahedron: 30 spheres and 30
// cylinders. 1 + 4 + ... + size^2 objects in front of a wall.
#include "databases.h"

namespace spd {

namespace {

constexpr double k_radius = 0.07412;

std::vector<Vec3> dodecahedron() {
    std::vector<Vec3> points;
    for (int i = 0; i < 5; ++i)
        points.push_back(Vec3{std::cos(i * 2 * M_PI / 5), std::sin(i * 2 * M_PI / 5), 0} / (1 + k_radius));
    const double between_faces = 2 * std::acos(std::cos(M_PI / 3) / std::sin(M_PI / 5));
    for (int ring = 0; ring < 5; ++ring)
        for (int i = 0; i < 5; ++i)
            points.push_back(
                rotate(rotate(points[i], {1, 0, 0}, between_faces), {0, 0, 1}, M_PI * (2 * ring + 1) / 5));
    return points;
}

}  // namespace

void write_rings(SceneWriter& out, int size) {
    const double spread = 1 / std::sin(M_PI / 8);
    View view{.from = {-1, -spread, 0.5}, .at = {-1, 1 - spread, 0.5}};
    view.lights = {{3, -spread, 3}, {-4, -spread, 1}, {2, -spread, -4}};
    out.begin(view);

    out.surface({.color = {1, 1, 1}});
    const double y = spread * (size + 1), half = 1.01 * (y + spread) * std::tan(M_PI / 8);
    const Vec3 wall[] = {{half - 1, y, half + 0.5},
                         {-half - 1, y, half + 0.5},
                         {-half - 1, y, -half + 0.5},
                         {half - 1, y, -half + 0.5}};
    out.polygon(wall);

    constexpr Color k_colors[6] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}};
    const std::vector<Vec3> points = dodecahedron();
    for (int layer = 0; layer < size; ++layer) {
        for (int z = 0; z <= layer; ++z) {
            for (int x = 0; x <= layer; ++x) {
                const Vec3 offset{2.0 * x - layer, spread * (layer + 1), 2.0 * z - layer};
                for (int i = 0; i < 30; ++i) {
                    const int before = i % 5 == 0 ? i + 4 : i - 1;
                    if (i % 5 == 0)
                        out.surface(
                            {.color = k_colors[i / 5], .kd = 0.5, .ks = 0.2, .shine = shine_of_angle(37)});
                    out.cone(points[i] + offset, k_radius, points[before] + offset, k_radius);
                    out.sphere(points[i] + offset, k_radius);
                }
            }
        }
    }
}

}  // namespace spd
