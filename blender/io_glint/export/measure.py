# SPDX-License-Identifier: Apache-2.0
"""Shapes of a kind that the user named, with the size of the mesh; and flat meshes. Pure."""
import math

from .shapes import CLOSE, Shape, bounds, centre_of_bounds, face_normal
from .vectors import add, dot, length, sub, unit


def flat_extent(outline):
    """(centre, unit normal) of a mesh whose faces are all in one plane; None if they are not."""
    vertices, faces = outline.vertices, outline.faces
    if not faces or len(vertices) < 3:
        return None
    normal = (0.0, 0.0, 0.0)
    for face in faces:
        normal = add(normal, face_normal([vertices[v] for v in face]))
    centre = centre_of_bounds(vertices)
    size = max(math.dist(v, centre) for v in vertices)
    if length(normal) <= 1e-12 * size * size:
        return None
    normal = unit(normal)
    if any(abs(dot(sub(v, centre), normal)) > CLOSE * size for v in vertices):
        return None
    return centre, normal


def measure(kind, outline):
    """The Shape of a kind that the user named, from the mesh's extent: axis along z. None if the mesh has no such extent."""
    if not outline.vertices:
        return None
    low, high = bounds(outline.vertices)
    centre = tuple((a + b) / 2 for a, b in zip(low, high))
    around = max(math.hypot(v[0] - centre[0], v[1] - centre[1]) for v in outline.vertices)
    bottom, top = (centre[0], centre[1], low[2]), (centre[0], centre[1], high[2])
    if kind == "PLANE":
        flat = flat_extent(outline)
        return Shape("plane", (("point", flat[0] if flat else centre),
                               ("normal", flat[1] if flat else (0.0, 0.0, 1.0))))
    if kind == "SPHERE":
        radius = max(math.dist(v, centre) for v in outline.vertices)
        return Shape("sphere", (("center", centre), ("radius", radius))) if radius > 0 else None
    if kind == "BOX":
        return Shape("box", (("min", low), ("max", high)))
    if around <= 0:
        return None
    if kind == "DISC":
        return Shape("disc", (("center", centre), ("normal", (0.0, 0.0, 1.0)), ("radius", around)))
    if high[2] <= low[2]:
        return None
    caps = any(all(abs(outline.vertices[v][2] - z) <= CLOSE * (high[2] - low[2]) for v in face)
               for face in outline.faces for z in (low[2], high[2]))
    if kind == "CYLINDER":
        return Shape("cylinder", (("from", bottom), ("to", top), ("radius", around), ("caps", caps)))
    radii = tuple(max((math.hypot(v[0] - centre[0], v[1] - centre[1]) for v in outline.vertices
                       if abs(v[2] - z) <= CLOSE * (high[2] - low[2])), default=0.0) for z in (low[2], high[2]))
    if max(radii) <= 0:
        return None
    return Shape("cone", (("from", bottom), ("to", top), ("radius", radii), ("caps", caps)))
