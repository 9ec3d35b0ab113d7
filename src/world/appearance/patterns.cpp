// SPDX-License-Identifier: Apache-2.0
#include "world/appearance/patterns.h"

#include <cmath>

#include "glint/texture.h"
#include "math/elementary.h"

namespace glint {

double checker(Vec3 p) {
    const double cell = std::floor(p.x + k_checker_margin) + std::floor(p.y + k_checker_margin) +
                        std::floor(p.z + k_checker_margin);
    return (cell - 2 * std::floor(cell / 2)) / 2;
}

double leopard(Vec3 p) {
    const double mean = (sin(p.x) + sin(p.y) + sin(p.z)) / 3;
    return mean * mean;
}

double bricks(Vec3 p, Vec3 mortar) {
    const auto is_mortar = [](double at, double part) {
        at += k_checker_margin;
        return at - std::floor(at) >= 1 - part;
    };
    const double layer = std::floor(p.y + k_checker_margin);
    const bool is_odd = layer - 2 * std::floor(layer / 2) > 0;
    const bool is_in_mortar = is_mortar(p.y, mortar.y) || is_mortar(p.x + (is_odd ? 0.5 : 0), mortar.x) ||
                              is_mortar(p.z + (is_odd ? 0 : 0.5), mortar.z);
    return is_in_mortar ? 0 : 0.5;
}

// The hexagons around the points (1.5 i, sqrt(3) (j + i / 2)) of x and z: (j + 2 i modulo 3) / 4 in the
// nearest one, which is in one of the two columns beside x.
double hexagons(Vec3 p) {
    constexpr double k_height = 0x1.bb67ae8584caap+0;  // sqrt(3)
    double best = 0, number = 0;
    const double column = std::floor(p.x / 1.5);
    for (int k = 0; k < 2; ++k) {
        const double i = column + k, row = std::floor(p.z / k_height - i / 2 + 0.5);
        const double x = p.x - 1.5 * i, z = p.z - k_height * (row + i / 2);
        const double distance = x * x + z * z;
        if (k > 0 && distance >= best) continue;
        best = distance;
        number = row + 2 * i;
    }
    return (number - 3 * std::floor(number / 3)) / 4;
}

double mandelbrot(Vec3 p, double iterations) {
    const double most = std::floor(iterations);
    double x = p.x, y = p.y;
    // Within the set, z soon repeats itself to the bit: then it never leaves. It is compared with itself at
    // steps that double.
    double kept_x = x, kept_y = y, next = 1;
    for (double n = 0; n < most; ++n) {
        const double difference = x * x - y * y;
        y = 2 * x * y + p.y;
        x = difference + p.x;
        if (!(x * x + y * y <= 4)) return n / most;
        if (x == kept_x && y == kept_y) return 1;
        if (n < next) continue;
        kept_x = x, kept_y = y;
        next = 2 * n;
    }
    return 1;
}

}  // namespace glint
