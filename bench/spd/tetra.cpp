// SPDX-License-Identifier: Apache-2.0
// Sierpinski's pyramid: a tetrahedron subdivided recursively; 4^size triangles.
#include "databases.h"

namespace spd {

namespace {

// The corners of the cube [-1, 1]^3 that form a tetrahedron.
constexpr Vec3 k_corners[4] = {{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}};

void divide(SceneWriter& out, Vec3 center, double half, int depth) {
    if (depth > 1) {
        for (const Vec3& corner : k_corners) divide(out, center + corner * (half / 2), half / 2, depth - 1);
        return;
    }
    constexpr int faces[4][3] = {{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}};
    for (const auto& face : faces) {
        Vec3 triangle[3];
        for (int i = 0; i < 3; ++i) triangle[i] = center + k_corners[face[i]] * half;
        out.polygon(triangle);
    }
}

}  // namespace

void write_tetra(SceneWriter& out, int size) {
    View view{.from = {1.022846, -3.177154, -2.174512},
              .at = {-0.004103, -0.004103, 0.216539},
              .up = {-0.816497, -0.816497, 0.816497}};
    view.lights = {{2, -18, -5}};
    out.begin(view);
    out.surface({.color = {1, 0.2, 0.2}});
    divide(out, {0, 0, 0}, 1, size);
}

}  // namespace spd
