// SPDX-License-Identifier: Apache-2.0
// A cube of size^3 gears above a mirror, some of glass. A gear has two concave faces of 144 vertices, and 144
// rectangles around them.
#include <algorithm>

#include "databases.h"

namespace spd {

namespace {

constexpr int k_teeth = 36;
constexpr double k_outer = 0.995, k_inner = 0.9;  // relative to the radius; neighbours do not quite touch

struct Gear {
    Vec3 center;
    double angle, radius, thickness;
};

// The outline at height z, counter-clockwise from above, or clockwise if `turn` is -1.
std::vector<Vec3> outline(const Gear& gear, double z, double turn) {
    constexpr struct {
        double tooth, radius;
    } k_tooth[4] = {{-0.19, k_outer}, {0.19, k_outer}, {0.3, k_inner}, {0.7, k_inner}};
    std::vector<Vec3> points;
    for (int tooth = 0; tooth < k_teeth; ++tooth) {
        for (const auto& corner : k_tooth) {
            const double angle = gear.angle + turn * (tooth + corner.tooth) * 2 * M_PI / k_teeth;
            const double radius = gear.radius * corner.radius;
            points.push_back({gear.center.x + radius * std::cos(angle),
                              gear.center.y + radius * std::sin(angle), gear.center.z + z});
        }
    }
    return points;
}

void write_gear(SceneWriter& out, const Gear& gear) {
    const std::vector<Vec3> top = outline(gear, 0, 1);
    out.polygon(top);
    const Vec3 down{0, 0, -gear.thickness};
    for (std::size_t i = 0; i < top.size(); ++i) {
        const Vec3 a = top[i], b = top[(i + 1) % top.size()];
        const Vec3 side[] = {a, a + down, b + down, b};
        out.polygon(side);
    }
    out.polygon(outline(gear, -gear.thickness, -1));
}

// A pseudo-random color whose largest channel is 1.
Color gear_color(int x, int y, int z) {
    const auto part = [](int n) { return 0.01 + n / 7.0 - n / 7; };
    const Color c{part((x * 3 + y * 2 + z + 1) * 5), part((y * 3 + z * 2 + x + 1) * 3),
                  part((z * 3 + x * 2 + y + 1) * 2)};
    return c * (1 / std::max({c.r, c.g, c.b}));
}

}  // namespace

void write_gears(SceneWriter& out, int size) {
    View view{.from = {-1.1, -2.1, 2.6}, .at = {0, 0, 0}};
    view.lights = {{2, 4, 4}, {-2, 4, 3}, {2, -2.5, 2.5}, {-1, -4, 2}, {-1.111, -2.121, 2.626}};
    out.begin(view);

    out.surface({.color = {1, 0.85, 0.7}, .kd = 0.3, .ks = 0.6, .shine = shine_of_angle(37)});
    const Vec3 ground[] = {{2, 2, 0}, {-2, 2, 0}, {-2, -2, 0}, {2, -2, 0}};
    out.polygon(ground);

    const double depth = 1 - k_inner, radius = 1 / (size - (size - 1) * depth / 2);
    const double step = radius * (2 - depth), thickness = std::min(0.1, 1 / (2.0 * size));
    for (int z = 0; z < size; ++z) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const Color color = gear_color(x, y, z);
                if ((x * 4 + y * 2 + z) % 5 == 0)
                    out.surface({.color = color, .kd = 0.2, .transmission = 0.8, .ior = 1.1});
                else
                    out.surface({.color = color});
                const Vec3 center{radius - 1 + x * step, radius - 1 + y * step,
                                  1 - z / static_cast<double>(size)};
                write_gear(out, {center, M_PI * ((x + y + z) % 2) / k_teeth, radius, thickness});
            }
        }
    }
}

}  // namespace spd
