# SPDX-License-Identifier: Apache-2.0
"""A whole ray tracer for tests of `glint diagnose`: scenes/cgfs/three_mirrors.cgfs, as "Computer Graphics from Scratch" renders it.

    MISTAKE=normal-reversed GLINT_PIXELS=80,100 python3 tracer.py 160 160 > picture.ppm

MISTAKE: one of mistakes.json; without it, the picture is right. --list prints all that this tracer has.
Colors are 0 to 255, and directions have any length, as in the book.
"""
import math
import os
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/trace_log"))
import glint_log as log  # noqa: E402

MISTAKE = os.environ.get("MISTAKE", "")
INF = math.inf
BACKGROUND = (0, 0, 0)
LIMIT = 3


class Sphere:
    def __init__(self, center, radius, color, specular, reflective):
        self.center, self.radius, self.color, self.specular, self.reflective = center, radius, color, specular, reflective


SPHERES = [
    Sphere((0, -1, 3), 1, (255, 0, 0), 500, 0.2),
    Sphere((-2, 0, 4), 1, (0, 255, 0), 10, 0.4),
    Sphere((2, 0, 4), 1, (0, 0, 255), 500, 0.3),
    Sphere((0, -5001, 0), 5000, (255, 255, 0), 1000, 0.5),
]
LIGHTS = [("ambient", 0.2, None), ("point", 0.6, (2, 1, 0)), ("directional", 0.2, (1, 4, 4))]


def wrong(name):
    return name == MISTAKE


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(a, f):
    return (a[0] * f, a[1] * f, a[2] * f)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def length(a):
    return math.sqrt(dot(a, a))


def intersect_sphere(origin, direction, sphere):
    oc = sub(origin, sphere.center)
    a = 1 if wrong("unit-direction-assumed") else dot(direction, direction)
    b = 2 * dot(oc, direction)
    c = dot(oc, oc) - sphere.radius * sphere.radius
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return INF, INF
    root = math.sqrt(discriminant)
    return (-b + root) / (2 * a), (-b - root) / (2 * a)


def closest(origin, direction, t_min, t_max):
    """The shape's index and t of the nearest hit; None, INF."""
    best, best_t = None, INF
    for i, sphere in enumerate(SPHERES):
        t1, t2 = intersect_sphere(origin, direction, sphere)
        if wrong("far-root"):
            t2 = t1
        for t in (t1, t2):
            if not t_min < t < t_max:
                continue
            if wrong("last-hit") or t < best_t and not (wrong("first-hit") and best is not None and best != i):
                best, best_t = i, t
    return best, best_t


def reflect(v, normal):
    """v, which points away from the surface, mirrored at the normal."""
    return sub(mul(normal, 2 * dot(v, normal)), v)


def light_of(sphere, point, normal, view):
    """The surface's own light."""
    color, total = sphere.color, (0, 0, 0)
    ambient = mul(color, 0 if wrong("ambient-missing") else LIGHTS[0][1])
    log.value("ambient", ambient)
    total = ambient
    for number, (kind, intensity, vector) in enumerate(LIGHTS, 1):
        if kind == "ambient":
            continue
        log.light(number)
        if wrong("ambient-for-each-light"):
            total = add(total, ambient)
        if wrong("light-color-missing"):
            intensity = 1
        if kind == "point":
            to_light, t_max = sub(vector, point), 1
            if wrong("light-reversed"):
                to_light = sub(point, vector)
            if wrong("light-position"):
                to_light = vector
        else:
            to_light, t_max = vector, INF
            if wrong("directional-reversed"):
                to_light = mul(vector, -1)
            if wrong("directional-as-point"):
                to_light = sub(vector, point)
        log.value("L", to_light)
        if kind == "point":
            log.value("distance", length(to_light))
        n_l = dot(normal, to_light) / (1 if wrong("light-not-unit") else length(to_light))
        log.value("N.L", n_l)
        mirrored = reflect(to_light, normal)
        if wrong("reflection-sign"):
            mirrored = add(mul(normal, 2 * dot(to_light, normal)), to_light)
        log.value("R", mirrored)
        r_v = dot(mirrored, view) / (length(mirrored) * (1 if wrong("view-not-unit") else length(view)))
        log.value("R.V", r_v)
        power = 0
        if r_v > 0 or wrong("highlight-abs"):
            n = sphere.specular * (4 if wrong("exponent-times-4") else 1)
            power = abs(r_v) ** (1 if wrong("exponent-missing") else n)
            if wrong("exponent-as-factor"):
                power = n * r_v
        log.value("power", power)
        start = (0, 0, 0) if wrong("shadow-from-origin") else point
        log.ray("shadow")
        log.value("origin", start)
        log.value("direction", to_light)
        log.end()
        epsilon = 0 if wrong("shadow-no-epsilon") else 0.001
        blocked = closest(start, to_light, epsilon, t_max)[0] is not None
        if wrong("no-shadows"):
            blocked = False
        log.value("blocked", blocked)
        visible = 0 if blocked else 1
        cosine = max(n_l, 0)
        diffuse = mul((255, 255, 255) if wrong("diffuse-color-missing") else color, intensity * cosine * visible)
        highlight = intensity * power * (1 if wrong("specular-in-shadow") else visible)
        if wrong("specular-times-cosine"):
            highlight *= max(n_l, 0)
        specular = mul(color, highlight)
        log.value("diffuse", diffuse)
        log.value("specular", specular)
        total = add(total, add(diffuse, specular))
    if wrong("clamp-before-sum"):
        total = tuple(min(v, 255) for v in total)
    log.value("local", total)
    return total


def trace(origin, direction, t_min, depth, kind="camera", weight=None):
    log.ray(kind)
    log.value("origin", origin)
    log.value("direction", direction)
    if weight is not None:
        log.value("weight", weight)
    index, t = closest(origin, direction, -INF if wrong("negative-t") else t_min, INF)
    if index is None:
        log.value("miss")
        log.value("color", BACKGROUND)
        log.end()
        return BACKGROUND
    sphere = SPHERES[index]
    point = mul(direction, t) if wrong("point-without-origin") else add(origin, mul(direction, t))
    normal = sub(point, sphere.center)
    if wrong("normal-is-point"):
        normal = point
    if not wrong("normal-not-unit"):
        normal = mul(normal, 1 / length(normal))
    if wrong("normal-reversed"):
        normal = mul(normal, -1)
    view = mul(direction, -1)
    if wrong("view-reversed"):
        view = direction
    if wrong("view-to-camera"):
        view = mul(point, -1)
    log.value("shape", index + 1)
    log.value("t", t)
    log.value("P", point)
    log.value("N", normal)
    log.value("V", view)
    color = light_of(sphere, point, normal, view)
    r = sphere.reflective
    if depth > 0 and r > 0:
        mirrored = reflect(mul(direction, -1), normal)
        if wrong("mirror-direction-sign"):
            mirrored = mul(mirrored, -1)
        if wrong("mirror-along-normal"):
            mirrored = add(direction, mul(normal, dot(direction, normal)))
        weight = 1 if wrong("mirror-weight-missing") else r
        epsilon = 0 if wrong("mirror-no-epsilon") else 0.001
        start = (0, 0, 0) if wrong("mirror-from-camera") else point
        reflected = trace(start, mirrored, epsilon, depth - 1, "mirror", weight)
        share = 1 - r
        if wrong("mirror-add"):
            share = 1
        if wrong("blend-reversed"):
            share, weight = r, 1 - r
        color = add(mul(color, share), mul(reflected, weight))
    log.value("color", color)
    log.end()
    return color


def direction_of(x, y, width, height):
    """Of the ray through the lower left corner of column x, row y from the top."""
    canvas_x, canvas_y = x - width / 2, height / 2 - 1 - y
    if wrong("rows-flipped"):
        canvas_y = -canvas_y
    if wrong("columns-mirrored"):
        canvas_x = -canvas_x
    if wrong("pixel-centre"):
        canvas_x, canvas_y = canvas_x + 0.5, canvas_y + 0.5
    if wrong("integer-division"):
        return (canvas_x // width, canvas_y // height, 1)
    if wrong("aspect-stretched"):
        return (canvas_x / width * 1.5, canvas_y / height, 1)
    size = 2 if wrong("viewport-double") else 1
    return (canvas_x * size / width, canvas_y * size / height, -1 if wrong("view-backwards") else 1)


def byte_of(v):
    v = min(max(v, 0), 255)
    if wrong("gamma"):
        v = 255 * (v / 255) ** (1 / 2.2)
    if wrong("bytes-truncated"):
        return int(v)
    if wrong("bytes-times-256"):
        return int(v / 255 * 256) % 256
    return round(v)


def render(width, height):
    limit = LIMIT + (1 if wrong("depth-more") else -1 if wrong("depth-less") else 0)
    picture = bytearray()
    log.about("colors", 255)
    log.about("size", width, height)
    for y in range(height):
        for x in range(width):
            log.pixel(x, y)
            color = trace((0, 0, 0), direction_of(x, y, width, height), 1, limit)
            log.value("color", color)
            rgb = [byte_of(v) for v in color]
            if wrong("colors-swapped"):
                rgb.reverse()
            log.value("bytes", rgb)
            log.end_pixel()
            picture += bytes(rgb)
    sys.stdout.buffer.write(b"P6\n%d %d\n255\n" % (width, height) + picture)


def main():
    with open(__file__, encoding="utf-8") as text:
        mistakes = re.findall(r'wrong\("([a-z0-9-]+)"\)', text.read())
    mistakes = list(dict.fromkeys(mistakes))
    if sys.argv[1:] == ["--list"]:
        print("\n".join(mistakes))
        return
    if MISTAKE and MISTAKE not in mistakes:
        sys.exit("tracer.py: there is no mistake " + MISTAKE)
    render(*(int(a) for a in sys.argv[1:3])) if len(sys.argv) > 2 else render(160, 160)


main()
