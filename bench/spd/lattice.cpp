// SPDX-License-Identifier: Apache-2.0
// A cubic lattice inside [0, 1]^3: (size + 1)^3 mirroring spheres, joined by matte cylinders.
#include "databases.h"

namespace spd {

void write_lattice(SceneWriter& out, int size) {
    const double cell = 1.0 / size, ball = cell / 4, rod = cell / 16;
    const double middle = (size / 2 + 0.5) * cell;
    View view{.from = {middle, 1, 1 - cell / 2},
              .at = {middle, -1, -1 - cell / 2},
              .up = {0.2, 1, 0},
              .angle = 60,
              .hither = 0};
    view.lights = {{2, 0.5, 0.5},  {-1, 0.5, 0.5}, {0.5, 2, 0.5},
                   {0.5, -1, 0.5}, {0.5, 0.5, 2},  {0.5, 0.5, -1}};
    out.begin(view);

    const Surface shiny{.color = {0.9, 0.9, 0.9}, .kd = 0.5, .ks = 0.5, .shine = shine_of_angle(37)};
    const struct {
        Vec3 axis;
        Color color;
    } rods[] = {{{1, 0, 0}, {0.9, 0.1, 0.1}}, {{0, 1, 0}, {0.1, 0.9, 0.1}}, {{0, 0, 1}, {0.1, 0.1, 0.9}}};
    const double inset = ball * (1 - std::sqrt(0.25)) * 0.99;  // the ends of a rod are inside the balls
    for (int x = 0; x <= size; ++x) {
        for (int y = 0; y <= size; ++y) {
            for (int z = 0; z <= size; ++z) {
                const Vec3 at = Vec3{x * 1.0, y * 1.0, z * 1.0} / size;
                out.surface(shiny);
                out.sphere(at, ball);
                const bool last[] = {x == size, y == size, z == size};
                for (int i = 0; i < 3; ++i) {
                    if (last[i]) continue;
                    out.surface({.color = rods[i].color, .kd = 0.99});
                    out.cone(at + rods[i].axis * inset, rod, at + rods[i].axis * (cell - inset), rod);
                }
            }
        }
    }
}

}  // namespace spd
