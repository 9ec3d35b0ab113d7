# SPDX-License-Identifier: Apache-2.0 OR MIT-0
"""One diffuse sphere, lit by one point light (diffuse_sphere.glint), with the calls that write a log for `glint diagnose`.

    GLINT_PIXELS="40,18;2,2" python3 diffuse_sphere.py > diffuse_sphere.ppm
"""
import math
import sys

import glint_log as log

WIDTH, HEIGHT, FOV_DEGREES = 64, 48, 50
EYE, CENTER, RADIUS, DIFFUSE = (0, 0, 4), (0, 0, 0), 1, (0.9, 0.5, 0.2)
LIGHT, LIGHT_COLOR = (3, 4, 5), (1, 0.9, 0.8)


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def hit_sphere(origin, direction):
    """The distance of the nearest hit, or None."""
    from_center = sub(origin, CENTER)
    b = dot(from_center, direction)
    root = b * b - (dot(from_center, from_center) - RADIUS * RADIUS)
    t = -b - math.sqrt(root) if root >= 0 else -1
    return t if t > 0 else None


def trace(origin, direction):
    log.ray("camera")
    log.value("origin", origin)
    log.value("direction", direction)
    color = (0, 0, 0)
    t = hit_sphere(origin, direction)
    if t is None:
        log.value("miss")
    else:
        p = tuple(o + t * d for o, d in zip(origin, direction))
        n = unit(sub(p, CENTER))
        to_light = unit(sub(LIGHT, p))
        n_l = dot(n, to_light)
        color = tuple(k * i * max(n_l, 0) for k, i in zip(DIFFUSE, LIGHT_COLOR))
        log.value("shape", 1)
        log.value("t", t)
        log.value("P", p)
        log.value("N", n)
        log.light(1)
        log.value("L", to_light)
        log.value("N.L", n_l)
        log.value("diffuse", color)
    log.value("color", color)
    log.end()
    return color


def main():
    width = 2 * math.tan(math.radians(FOV_DEGREES / 2))  # of the picture, at the distance 1
    picture = bytearray()
    for y in range(HEIGHT):
        for x in range(WIDTH):
            log.pixel(x, y)
            to_pixel = (((x + 0.5) / WIDTH - 0.5) * width, (0.5 - (y + 0.5) / HEIGHT) * width * HEIGHT / WIDTH, -1)
            color = trace(EYE, unit(to_pixel))
            rgb = [round(255 * min(max(v, 0), 1)) for v in color]
            log.value("bytes", rgb)
            log.end_pixel()
            picture += bytes(rgb)
    sys.stdout.buffer.write(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT) + picture)


main()
