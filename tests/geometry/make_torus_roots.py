#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes torus_roots.h: rays and tori, with the first root of each ray to 400 bits, rounded to a double.

    tests/geometry/make_torus_roots.py > tests/geometry/torus_roots.h"""
import decimal
import math
import random

from decimal import Decimal as D

decimal.getcontext().prec = 120  # digits
ROUNDS = 420


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def value(k, t):
    total = D(0)
    for c in reversed(k):
        total = total * t + c
    return total


def roots(k, low, high):
    """The real roots of a polynomial between two numbers: one in each interval between the derivative's roots."""
    if len(k) == 2:
        return [-k[0] / k[1]] if k[1] else []
    ends = [low, *(t for t in roots([i * c for i, c in enumerate(k)][1:], low, high) if low < t < high), high]
    found = []
    for a, b in zip(ends, ends[1:]):
        below = value(k, a) < 0
        if below == (value(k, b) < 0):
            continue
        for _ in range(ROUNDS):
            middle = (a + b) / 2
            if (value(k, middle) < 0) == below:
                a = middle
            else:
                b = middle
        found.append(a)
    return found


def first_root(center, axis, radius, tube, origin, direction):
    """The least t > 0 at which the ray intersects the torus, or -1."""
    axis = [D(a) for a in axis]
    size = dot(axis, axis).sqrt()
    axis = [a / size for a in axis]
    q, d = [D(o) - D(c) for o, c in zip(origin, center)], [D(x) for x in direction]
    near = -dot(q, d) / dot(d, d)  # t there; s = t - near
    q = [x + near * y for x, y in zip(q, d)]
    big, small = D(radius), D(tube)
    q_y, d_y = dot(q, axis), dot(d, axis)
    square = [dot(q, q), 2 * dot(q, d), dot(d, d)]
    across = [square[0] - q_y * q_y, square[1] - 2 * q_y * d_y, square[2] - d_y * d_y]
    sum_ = [square[0] + big * big - small * small, square[1], square[2]]
    k = [D(0)] * 5
    for i in range(3):
        for j in range(3):
            k[i + j] += sum_[i] * sum_[j]
        k[i] -= 4 * big * big * across[i]
    reach = 2 * (big + small) / dot(d, d).sqrt()
    found = [s + near for s in roots(k, -reach, reach) if s + near > 0]
    return float(min(found)) if found else -1.0


def unit(rng):
    while True:
        v = [rng.uniform(-1, 1) for _ in range(3)]
        size = math.sqrt(dot(v, v))
        if 0.1 < size < 1:
            return [x / size for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def case(rng, number):
    """A torus and a ray to a point near its surface: across it, or along it; from near or far."""
    radius = 10 ** rng.uniform(-2, 2)
    tube = radius * (rng.uniform(0.05, 0.9), 1e-3, rng.uniform(1.05, 1.9))[number % 3]
    center = [rng.uniform(-3, 3) * radius for _ in range(3)]
    axis = [x * 2 for x in unit(rng)]
    out = cross(axis, unit(rng))
    size = math.sqrt(dot(out, out))
    out = [x / size for x in out]
    angle = rng.uniform(0, 2 * math.pi)
    normal = [math.cos(angle) * o + math.sin(angle) * a / 2 for o, a in zip(out, axis)]
    is_tangent = number // 3 % 2 == 1
    away = (radius + tube) * (1e6 if number // 6 % 2 == 1 else rng.uniform(0.5, 20))
    off = 0
    if is_tangent:  # and more than what rounding of the ray's numbers changes
        off = max(tube * 10 ** rng.uniform(-13, -3), 2 ** -49 * (away + 8 * radius)) * rng.choice((-1, 1))
    point = [c + radius * o + (tube + off) * n for c, o, n in zip(center, out, normal)]
    along = unit(rng)
    if is_tangent:
        along = cross(normal, along)
        size = math.sqrt(dot(along, along))
        along = [x / size for x in along]
    origin = [p - a * away for p, a in zip(point, along)]
    scale = 10 ** rng.uniform(-2, 2)
    return center, axis, radius, tube, origin, [a * scale for a in along]


def main():
    rng = random.Random(4)
    print("// SPDX-License-Identifier: Apache-2.0\n#pragma once\n"
          "// Rays and the first t > 0 at which they intersect a torus, or -1: computed to 400 bits, by\n"
          "// make_torus_roots.py.\n#include \"glint/shapes.h\"\n\nnamespace glint::test {\n\n"
          "struct TorusRoot {\n    Torus torus;\n    Vec3 origin, direction;\n    double t;\n};\n\n"
          "// clang-format off\ninline constexpr TorusRoot k_torus_roots[] = {")
    for number in range(180):
        center, axis, radius, tube, origin, direction = values = case(rng, number)
        triples = [", ".join(map(repr, v)) for v in (center, axis, origin, direction)]
        print("    {{{%s}, {%s}, %r, %r},\n     {%s}, {%s}, %r}," % (
            *triples[:2], radius, tube, *triples[2:], first_root(*values)))
    print("};\n// clang-format on\n\n}  // namespace glint::test")


if __name__ == "__main__":
    main()
