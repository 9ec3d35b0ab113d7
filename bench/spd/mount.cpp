// SPDX-License-Identifier: Apache-2.0
// A fractal mountain of 2 * 4^size triangles by midpoint displacement, and four glass spheres.
#include "databases.h"

namespace spd {

namespace {

// Gaussian deviates from a linear congruential generator (Numerical Recipes, gasdev), as in the database's
// own program.
double gaussian(int seed) {
    constexpr int k_modulus = 134456, k_factor = 8121, k_add = 28411;
    for (;;) {
        const int first = (k_add + seed * k_factor) % k_modulus;
        seed = (k_add + first * k_factor) % k_modulus;
        const double a = first * 2.0 / k_modulus - 1, b = seed * 2.0 / k_modulus - 1, r = a * a + b * b;
        if (r < 1) return a * std::sqrt(-2 * std::log(r) / r);
    }
}

struct Mountain {
    SceneWriter& out;
    int size;
    double roughness;

    // The deviate of a grid point. This hash repeats within the mountain, as in the original database.
    double deviate(int x, int y) const {
        const auto shifted = [this](int value, int bits) {
            const int by = bits - size;
            return static_cast<unsigned long>(by >= 0 ? static_cast<long>(value) << by : value >> -by);
        };
        return gaussian(21 + static_cast<int>((shifted(x, 23) + shifted(y, 15) + shifted(x, 7)) & 0xffff));
    }

    Vec3 point(int x, int y, double z) const {
        const double cell = 2.0 / (1 << size);
        return {-1 + x * cell, -1 + y * cell, z};
    }

    // The square at (x, y), by the heights of its corners counter-clockwise.
    void grow(int width, int x, int y, double a, double b, double c, double d) const {
        if (width == 1) {
            const Vec3 p = point(x, y, a), q = point(x + 1, y, b), r = point(x + 1, y + 1, c),
                       s = point(x, y + 1, d);
            const Vec3 first[] = {p, q, r}, second[] = {r, s, p};
            out.polygon(first);
            out.polygon(second);
            return;
        }
        const int half = width / 2;
        const double rise = half * 2.0 / (1 << size) * roughness;
        const double ab = (a + b) / 2 + rise * deviate(x + half, y);
        const double bc = (b + c) / 2 + rise * deviate(x + width, y + half);
        const double cd = (c + d) / 2 + rise * deviate(x + half, y + width);
        const double da = (d + a) / 2 + rise * deviate(x, y + half);
        const double middle = (a + b + c + d) / 4 + 1.4142136 * rise * deviate(x + half, y + half);
        grow(half, x, y, a, ab, middle, da);
        grow(half, x + half, y, ab, b, bc, middle);
        grow(half, x + half, y + half, middle, bc, c, cd);
        grow(half, x, y + half, da, middle, cd, d);
    }
};

}  // namespace

void write_mount(SceneWriter& out, int size) {
    View view{.from = {-1.6, 1.6, 1.7}, .at = {0, 0, 0}, .hither = 0.01};
    view.lights = {{-100, -100, 100}};
    out.begin(view);

    out.surface({.color = {1, 1, 1},
                 .kd = 0.1,
                 .ks = 0.1,
                 .shine = shine_of_angle(6.7),
                 .transmission = 0.9,
                 .ior = 1.5});
    const Vec3 center{-0.8, 0.8, 1};
    const double radius = 0.17;
    const Vec3 top{0, 0, radius * std::sqrt(1.5)};
    const Vec3 low = rotate(top, unit({1, 1, 0}), std::acos(-1.0 / 3));
    out.sphere(center + top, radius);
    for (int i = 0; i < 3; ++i) out.sphere(center + rotate(low, {0, 0, 1}, i * 2 * M_PI / 3), radius);

    out.surface({.color = {0.5, 0.45, 0.35}});
    constexpr double k_fractal_dimension = 2.2;
    const double ratio = 2 / std::exp2(1 / (k_fractal_dimension - 1));
    Mountain{out, size, std::sqrt(ratio * ratio - 1)}.grow(1 << size, 0, 0, 0, 0, 0, 0);
}

}  // namespace spd
