// SPDX-License-Identifier: Apache-2.0
// Sphereflake: every sphere has nine smaller ones, a third as large; 1 + 9 + ... + 9^size spheres.
#include "databases.h"

namespace spd {

namespace {

struct Flake {
    SceneWriter& out;
    Vec3 children[9];  // from the middle of a sphere whose own direction is +z
};

void grow(const Flake& flake, Vec3 center, double radius, Vec3 direction, int depth) {
    flake.out.sphere(center, radius);
    if (depth == 0) return;
    const Vec3 across{-direction.y, direction.x, 0};  // z × direction
    for (const Vec3& child : flake.children) {
        Vec3 way = child;
        if (direction.z <= -0.9999)
            way = {-child.x, child.y, -child.z};
        else if (direction.z < 0.9999)
            way = rotate(child, unit(across), std::sqrt(1 - direction.z * direction.z), direction.z);
        grow(flake, center + way * (radius * 4 / 3), radius / 3, way, depth - 1);
    }
}

}  // namespace

void write_balls(SceneWriter& out, int size) {
    View view{.from = {2.1, 1.3, 1.7}, .at = {0, 0, 0}, .hither = 0.01};
    view.lights = {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}};
    out.begin(view);

    out.surface({.color = {1, 0.75, 0.33}, .kd = 0.8, .ior = 1});
    const Vec3 floor[] = {{12, 12, -0.5}, {-12, 12, -0.5}, {-12, -12, -0.5}, {12, -12, -0.5}};
    out.polygon(floor);

    out.surface({.color = {1, 0.9, 0.7}, .kd = 0.5, .ks = 0.5, .shine = shine_of_angle(37), .ior = 1});
    // Three edges of a cube that meet a face's diagonal, tilted so that they are evenly spaced around +z;
    // then the same, rotated by 40 and 80 degrees.
    const double d = std::sqrt(0.5);
    const Vec3 trio[3] = {{d, d, 0}, {d, 0, -d}, {0, d, -d}};
    Flake flake{out, {}};
    for (int set = 0; set < 3; ++set)
        for (int i = 0; i < 3; ++i)
            flake.children[3 * set + i] = rotate(rotate(trio[i], {d, -d, 0}, std::asin(2 / std::sqrt(6.0))),
                                                 {0, 0, 1}, set * 2 * M_PI / 3);
    grow(flake, {0, 0, 0}, 0.5, {0, 0, 1}, size);
}

}  // namespace spd
