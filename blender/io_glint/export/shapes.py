# SPDX-License-Identifier: Apache-2.0
"""Recognises glint's shapes in a mesh, in the object's own space. Pure: lists of numbers in, a Shape out.

AUTO (recognise) says a shape only if the mesh is one as nearly as its corners allow.
"""
import math
from dataclasses import dataclass

from .vectors import add, cross, dot, length, sub, unit

MIN_SPHERE_VERTICES = 42
MIN_SIDES = 24
MIN_FILL = 0.85  # of the ball's volume
CLOSE = 1e-4
KINDS = ("MESH", "SPHERE", "CYLINDER", "CONE", "PLANE", "DISC", "BOX")


@dataclass(frozen=True)
class Shape:
    """word: glint's. entries: its keys and values (numbers, vectors, booleans) before the matrix."""

    word: str
    entries: tuple

    def get(self, key):
        return dict(self.entries)[key]


@dataclass
class Outline:
    """What recognition needs of a mesh. faces: tuples of vertex numbers. smooth: for each face, whether it is shaded
    smoothly and its corners share their normals with the smooth faces around."""

    vertices: list
    faces: list
    smooth: list


def bounds(vertices):
    """(lower corner, upper corner)."""
    columns = list(zip(*vertices))
    return tuple(min(c) for c in columns), tuple(max(c) for c in columns)


def centre_of_bounds(vertices):
    low, high = bounds(vertices)
    return tuple((a + b) / 2 for a, b in zip(low, high))


def _mean(points):
    n = len(points)
    return tuple(sum(c) / n for c in zip(*points))


def face_normal(points):
    """Newell's: twice the area long."""
    total = (0.0, 0.0, 0.0)
    origin = points[0]
    for a, b in zip(points[1:], points[2:]):
        total = add(total, cross(sub(a, origin), sub(b, origin)))
    return total


def _volume(vertices, faces):
    total = 0.0
    for face in faces:
        a = vertices[face[0]]
        for i in range(1, len(face) - 1):
            total += dot(a, cross(vertices[face[i]], vertices[face[i + 1]]))
    return total / 6


def _snapped(point, size):
    """The point with 0 for coordinates that are rounding errors of a mesh of that size."""
    return tuple(0.0 if abs(c) < 1e-6 * size else c for c in point)


def sphere(outline, any_shading=False):
    """A ball of smooth faces. any_shading: flat faces too."""
    vertices = outline.vertices
    if len(vertices) < MIN_SPHERE_VERTICES or not (any_shading or all(outline.smooth)):
        return None
    centre = centre_of_bounds(vertices)
    radius = math.dist(vertices[0], centre)
    if not radius > 0 or any(abs(math.dist(v, centre) - radius) > CLOSE * radius for v in vertices):
        return None
    if abs(_volume([sub(v, centre) for v in vertices], outline.faces)) < MIN_FILL * 4 / 3 * math.pi * radius**3:
        return None
    return Shape("sphere", (("center", _snapped(centre, radius)), ("radius", radius)))


def box(outline):
    """(Shape along the axes, None), or (the unit box, the 3x4 matrix that turns it into a box at an angle)."""
    vertices, faces = outline.vertices, outline.faces
    if len(vertices) != 8 or len(faces) != 6 or any(outline.smooth) or any(len(f) != 4 for f in faces):
        return None
    used = [0] * 8
    for face in faces:
        for v in face:
            used[v] += 1
    if used != [3] * 8:
        return None
    corner = faces[0][0]
    near = set()
    for face in faces:
        if corner in face:
            i = face.index(corner)
            near |= {face[i - 1], face[(i + 1) % 4]}
    if len(near) != 3:
        return None
    origin = vertices[corner]
    edges = [sub(vertices[v], origin) for v in sorted(near)]
    size = max(length(e) for e in edges)
    if min(length(e) for e in edges) <= CLOSE * size:
        return None
    wanted = [add(add(add(origin, edges[0], i), edges[1], j), edges[2], k)
              for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    if any(min(math.dist(w, v) for v in vertices) > CLOSE * size for w in wanted):
        return None
    if any(abs(dot(a, b)) > CLOSE * length(a) * length(b) for a, b in
           ((edges[0], edges[1]), (edges[1], edges[2]), (edges[0], edges[2]))):
        return None
    if all(sum(abs(c) > CLOSE * size for c in e) == 1 for e in edges):
        low, high = bounds(vertices)
        return Shape("box", (("min", low), ("max", high))), None
    rows = tuple((edges[0][i], edges[1][i], edges[2][i], origin[i]) for i in range(3))
    return Shape("box", (("min", (0.0, 0.0, 0.0)), ("max", (1.0, 1.0, 1.0)))), rows


def _ring(points):
    """(centre, radius, normal) of at least MIN_SIDES points, equally spaced on a circle in any order; None if not."""
    if len(points) < MIN_SIDES:
        return None
    centre = _mean(points)
    first = sub(points[0], centre)
    radius = length(first)
    if not radius > 0 or any(abs(math.dist(p, centre) - radius) > CLOSE * radius for p in points):
        return None
    # The point nearest to a right angle with the first one.
    other = min(points, key=lambda p: abs(dot(sub(p, centre), first)))
    normal = unit(cross(first, sub(other, centre)))
    if any(abs(dot(sub(p, centre), normal)) > CLOSE * radius for p in points):
        return None
    u, v = unit(first), cross(normal, unit(first))
    angles = sorted(math.atan2(dot(sub(p, centre), v), dot(sub(p, centre), u)) for p in points)
    step = 2 * math.pi / len(points)
    if any(abs(b - a - step) > 0.01 * step for a, b in zip(angles, angles[1:])):
        return None
    return centre, radius, normal


def disc(outline):
    """One n-gon, or a fan of triangles around its centre."""
    vertices, faces = outline.vertices, outline.faces
    if len(faces) == 1 and len(faces[0]) == len(vertices):
        ring = _ring([vertices[v] for v in faces[0]])
    elif len(faces) == len(vertices) - 1 and all(len(f) == 3 for f in faces):
        common = set(faces[0]).intersection(*faces)
        hub = next(iter(common)) if len(common) == 1 else None
        ring = _ring([p for i, p in enumerate(vertices) if i != hub]) if hub is not None else None
        if ring and math.dist(vertices[hub], ring[0]) > CLOSE * ring[1]:
            ring = None
    else:
        return None
    if ring is None:
        return None
    normal = face_normal([vertices[v] for v in faces[0]])
    return Shape("disc", (("center", _snapped(ring[0], ring[1])), ("normal", _snapped(unit(normal), 1)),
                          ("radius", ring[1])))


def tube(outline, any_shading=False):
    """A cylinder or a cone (also cut off): two rings, or a ring and an apex, with smooth sides between them."""
    vertices, faces = outline.vertices, outline.faces
    candidates = _rings_along_axis(vertices)
    if candidates is None:
        return None
    (low, low_centre), (high, high_centre), axis = candidates
    levels = {i: 0 for i in low} | {i: 1 for i in high}
    sides = caps_low = caps_high = 0
    for face, smooth in zip(faces, outline.smooth):
        where = {levels[v] for v in face}
        if len(where) == 2:
            if not (smooth or any_shading) or len(face) > 4:
                return None
            sides += 1
        elif 0 in where:
            caps_low += 1
        else:
            caps_high += 1
    rings = []
    for indices, centre in ((low, low_centre), (high, high_centre)):
        points = [vertices[i] for i in indices if math.dist(vertices[i], centre) > CLOSE * length(axis)]
        if not points:
            rings.append((centre, 0.0, 0))
            continue
        ring = _ring(points)
        if ring is None or length(cross(ring[2], unit(axis))) > 1e-3:
            return None
        rings.append((ring[0], ring[1], len(points)))
    (from_, r0, n0), (to, r1, n1) = rings
    n = max(n0, n1)
    if sides not in (n, 2 * n) or (n0 and n1 and n0 != n1):
        return None
    if length(cross(unit(sub(to, from_)), unit(axis))) > 1e-3:
        return None
    caps = [bool(c) for c, r in ((caps_low, r0), (caps_high, r1)) if r > 0]
    if len(set(caps)) != 1:  # closed at one end only: glint's caps are both or none
        return None
    size = max(r0, r1)
    common = (("from", _snapped(from_, size)), ("to", _snapped(to, size)))
    if abs(r0 - r1) <= CLOSE * max(r0, r1):
        return Shape("cylinder", (*common, ("radius", r0), ("caps", caps[0])))
    return Shape("cone", (*common, ("radius", (r0, r1)), ("caps", caps[0])))


def _rings_along_axis(vertices):
    """Splits the vertices into two parallel planes: ((indices, centre), (indices, centre), axis); None if they are in
    more. The axis is one of the coordinate axes, as Blender's own primitives have it."""
    if len(vertices) < MIN_SIDES + 1:
        return None
    low, high = bounds(vertices)
    size = max(b - a for a, b in zip(low, high))
    for k in (2, 1, 0):
        if high[k] - low[k] <= CLOSE * size:
            continue
        first = [i for i, v in enumerate(vertices) if v[k] - low[k] <= CLOSE * size]
        second = [i for i, v in enumerate(vertices) if high[k] - v[k] <= CLOSE * size]
        if len(first) + len(second) != len(vertices) or max(len(first), len(second)) < MIN_SIDES:
            continue
        middle = [centre_of_bounds([vertices[i] for i in part]) for part in (first, second)]
        return (first, middle[0]), (second, middle[1]), sub(middle[1], middle[0])
    return None


def recognise(outline, any_shading=False):
    """(Shape, matrix or None) that the mesh is; None if it is none of glint's shapes.

    any_shading: what is shaded flat counts too, as in RT2, whose balls are flat."""
    if not outline.faces:
        return None
    found = sphere(outline, any_shading)
    if found:
        return found, None
    if len(outline.vertices) == 8:
        found = box(outline)
        if found:
            return found
    if len(outline.faces) == 1 or all(len(f) == 3 for f in outline.faces):
        found = disc(outline)
        if found:
            return found, None
    if any(outline.smooth) or any_shading:
        found = tube(outline, any_shading)
        if found:
            return found, None
    return None
