#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes quadric_roots.h: lines and quadrics, with the crossings of each line to 400 bits, rounded to doubles.

    tests/geometry/make_quadric_roots.py > tests/geometry/quadric_roots.h"""
import decimal
import math
import random

from decimal import Decimal as D

from make_torus_roots import cross, dot, unit

decimal.getcontext().prec = 120  # digits

# The squares' coefficients of an ellipsoid, hyperboloids and cones, cylinders, paraboloids, saddles, planes.
SQUARES = ((1, 2, 3), (1, -1, 1), (1, -2, -1), (1, 0, 1), (1, 0, 2), (1, 0, -1), (0, 0, 0))


def scaled(v):
    size = math.sqrt(dot(v, v))
    return [x / size for x in v]


def degree_2(squares, products, q):
    x, y, z = q
    return dot(squares, (x * x, y * y, z * z)) + dot(products, (x * y, x * z, y * z))


def gradient(squares, products, linear, q):
    x, y, z = q
    return [2 * squares[0] * x + products[0] * y + products[1] * z + linear[0],
            2 * squares[1] * y + products[0] * x + products[2] * z + linear[1],
            2 * squares[2] * z + products[1] * x + products[2] * y + linear[2]]


def crossings(squares, products, linear, constant, origin, direction):
    """The t at which the line crosses the surface, in ascending order."""
    squares, products, linear = [[D(x) for x in v] for v in (squares, products, linear)]
    o, d = [D(x) for x in origin], [D(x) for x in direction]
    a = degree_2(squares, products, d)
    b = dot(gradient(squares, products, linear, o), d) / 2
    c = degree_2(squares, products, o) + dot(linear, o) + D(constant)
    if a == 0:
        return [float(-c / (2 * b))] if b else []
    discriminant = b * b - a * c
    if discriminant < 0:
        return []
    return sorted(float((-b + side * discriminant.sqrt()) / a) for side in (1, -1))


def case(rng, number):
    """A quadric and a line through a point near its surface: across it, or along it; from near or far."""
    squares, products, linear = [float(x) for x in SQUARES[number % len(SQUARES)]], [0.0] * 3, [0.0] * 3
    number //= len(SQUARES)
    size = 10 ** rng.uniform(-2, 2)
    squares = [x / size ** 2 for x in squares]
    if number % 2 == 1 or not any(squares):  # not along the axes
        products = [rng.uniform(-1, 1) / size ** 2 if any(squares) else 0.0 for _ in range(3)]
        linear = [rng.uniform(-1, 1) / size for _ in range(3)]
    point = [rng.uniform(-2, 2) * size for _ in range(3)]
    constant = -(degree_2(squares, products, point) + dot(linear, point))
    normal = scaled(gradient(squares, products, linear, point))
    away = size * (1e6 if number // 4 % 2 == 1 else rng.uniform(0.5, 20))
    is_tangent = number // 2 % 2 == 1 and any(squares)
    along = unit(rng)
    if is_tangent:  # and off the surface by more than what rounding of the line's numbers changes
        off = max(size * 10 ** rng.uniform(-12, -3), 2 ** -48 * (away + 8 * size)) * rng.choice((-1, 1))
        point = [p + off * n for p, n in zip(point, normal)]
        along = scaled(cross(normal, along))
    origin = [p - a * away for p, a in zip(point, along)]
    scale = 10 ** rng.uniform(-2, 2)
    return squares, products, linear, constant, origin, [a * scale for a in along]


def main():
    rng = random.Random(5)
    print("// SPDX-License-Identifier: Apache-2.0\n#pragma once\n"
          "// Lines and the t at which they cross a quadric, infinity where there is none: computed to 400 bits, by\n"
          "// make_quadric_roots.py.\n#include \"glint/shapes.h\"\n\nnamespace glint::test {\n\n"
          "struct QuadricRoots {\n    Quadric quadric;\n    Vec3 origin, direction;\n    int count;\n    double t[2];\n};\n\n"
          "// clang-format off\ninline constexpr QuadricRoots k_quadric_roots[] = {")
    for number in range(8 * 2 * len(SQUARES)):
        squares, products, linear, constant, origin, direction = values = case(rng, number)
        triples = [", ".join(map(repr, v)) for v in (squares, products, linear, origin, direction)]
        found = crossings(*values)
        print("    {{{%s}, {%s}, {%s}, %r},\n     {%s}, {%s}, %d, {%s}}," % (
            *triples[:3], constant, *triples[3:], len(found), ", ".join(map(repr, found))))
    print("};\n// clang-format on\n\n}  // namespace glint::test")


if __name__ == "__main__":
    main()
