// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shapes with rays that are hard for them.
#include <cmath>

#include "geometry/random_values.h"
#include "glint/shapes.h"

namespace glint::test {

/// How many more random cases an optimised build tests.
#if defined(__OPTIMIZE__) && !defined(GLINT_SANITIZED)
inline constexpr int k_more_cases = 20;
#else
inline constexpr int k_more_cases = 1;
#endif

template <class Shape> struct Case {
    Shape shape;
    Vec3 origin, direction;
};

/// Half of the rays pass the sphere at r (1 +- 2^-k); half of the others start at its surface.
inline Case<Sphere> random_sphere(Random& random) {
    Case<Sphere> c;
    c.shape.radius = log_uniform(random, 1e-6, 1e6);
    const double reach = chance(random, 0.5) ? c.shape.radius : log_uniform(random, 1e-3, 1e6);
    c.shape.center = point_in_cube(random, reach);
    const Vec3 d = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
    const Vec3 aside = perpendicular(random, d);
    double closest = c.shape.radius;
    if (chance(random, 0.5)) {
        closest *= 1 + std::ldexp(chance(random, 0.7) ? -1.0 : 1.0, -3 - below(random, 50));
    } else {
        closest *= random.uniform(0, 1.1);
    }
    const double along = chance(random, 0.2) ? 0 : log_uniform(random, 1e-3 * c.shape.radius, 1e6);
    c.origin = c.shape.center + aside * closest - d * along;
    c.direction = d * log_uniform(random, 1e-3, 1e3);
    return c;
}

/// A ray from near the surface, at r (1 + 2^-k) or r (1 - 2^-k), in any direction.
inline Case<Sphere> ray_from_sphere(Random& random) {
    Case<Sphere> c = random_sphere(random);
    const double side = chance(random, 0.7) ? 1 : -1;
    const double distance = c.shape.radius * (1 + std::ldexp(side, -3 - below(random, 50)));
    c.origin = c.shape.center + unit_direction(random) * distance;
    return c;
}

}  // namespace glint::test
