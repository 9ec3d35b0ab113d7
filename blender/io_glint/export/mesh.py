# SPDX-License-Identifier: Apache-2.0
"""Meshes as triangles: Blender's arrays in, text out. Arrays are read with foreach_get, and without numpy."""
import math
from array import array
from functools import cached_property
from itertools import chain, product

from . import mesh_file, mesh_layers
from .shapes import Outline, face_normal, recognise
from .text import vector
from .vectors import cross, dot, sub

MAX_COORDINATE = 1e12
MAX_RECOGNISED = 50_000  # vertices, without numpy; for more, looking for a shape takes longer than drawing the triangles
MAX_CORNERS = 64  # of a face that is written as one polygon
INDEX = "I"  # the type that Blender 3 stores corners' numbers in, which are read several times as fast so
FLAT = 1e-6  # 1 - cosine, below which a corner's normal is the face's


def _read(collection, attribute, kind, width):
    values = array(kind, bytes(array(kind).itemsize * width * len(collection)))
    if values:
        collection.foreach_get(attribute, values)
    return values


def _normals(mesh, evaluated):
    """Those of corners."""
    if hasattr(mesh, "corner_normals"):  # from 4.1
        return _read(mesh.corner_normals, "vector", "f", 3)
    has_them = evaluated is not None and len(evaluated.loops) == len(mesh.loops) and any(evaluated.loops[0].normal)
    if has_them:
        next(iter(mesh.polygon_normals))  # makes them, as calc_normals_split() does: quads become other triangles without
    else:
        mesh.calc_normals_split()  # with normals of one's own, this takes longer than all else
    return _read(evaluated.loops if has_them else mesh.loops, "normal", "f", 3)


def _triples(values):
    return list(zip(values[0::3], values[1::3], values[2::3]))


class MeshData:
    """One evaluated mesh in its own space: Blender's arrays, and lists of tuples where they are asked for."""

    def __init__(self, mesh, evaluated=None):
        """evaluated: the mesh that `mesh` is a copy of, if there is one."""
        self.raw_normals = _normals(mesh, evaluated)
        mesh.calc_loop_triangles()
        self.raw_vertices = _read(mesh.vertices, "co", "f", 3)
        triangles = mesh.loop_triangles
        self.raw_loops = _read(triangles, "loops", INDEX, 3)
        self.loop_vertices = _read(mesh.loops, "vertex_index", INDEX, 1)
        self.raw_corners = (_read(triangles, "vertices", "i", 3) if mesh_file.np is None  # which takes longer
                            else mesh_file.taken(self.loop_vertices, self.raw_loops))
        self.areas = _read(triangles, "area", "f", 1)
        self.raw_face_normals = _read(triangles, "normal", "f", 3)
        self.slots = _read(triangles, "material_index", "i", 1)
        self.smooth = _read(mesh.polygons, "use_smooth", "b", 1)
        self.starts = _read(mesh.polygons, "loop_start", "i", 1)
        self.totals = _read(mesh.polygons, "loop_total", "i", 1)
        self.files = {}  # mesh_file.py
        self._box = self._outline = None
        self._recognised = {}
        sides = self._sides()
        self.is_finite = all(math.isfinite(v) and abs(v) <= MAX_COORDINATE for side in sides for v in side)

    vertices = cached_property(lambda self: _triples(self.raw_vertices))
    corners = cached_property(lambda self: _triples(self.raw_corners))
    loops = cached_property(lambda self: _triples(self.raw_loops))
    face_normals = cached_property(lambda self: _triples(self.raw_face_normals))
    normals = cached_property(lambda self: _triples(self.raw_normals))

    def __len__(self):
        return len(self.raw_corners) // 3

    def used_slots(self):
        return set(self.slots)

    def corners_of_bounds(self):
        """The eight corners of the box around the vertices."""
        if self._box is None:
            self._box = list(product(*self._sides()))
        return self._box

    def _sides(self):
        """(least, greatest) along each axis; NaN if a coordinate is NaN."""
        if not self.raw_vertices:
            return []
        if mesh_file.np is not None:
            return mesh_file.sides(self.raw_vertices)
        sides = [self.raw_vertices[i::3] for i in range(3)]
        return [(math.nan, math.nan) if math.isnan(sum(side)) else (min(side), max(side)) for side in sides]

    def outline(self):
        """What the recognition of shapes looks at; vertices without faces are left out."""
        if self._outline is None:
            self._outline = self._make_outline()
        return self._outline

    def recognise(self, any_shading=False):
        """shapes.recognise() of the mesh, once for all its instances."""
        if any_shading not in self._recognised:
            count = len(self.raw_vertices) // 3
            wanted = count <= MAX_RECOGNISED if mesh_file.np is None else count < 200 or mesh_file.may_be_a_shape(self)
            self._recognised[any_shading] = recognise(self.outline(), any_shading) if wanted else None
        return self._recognised[any_shading]

    def _make_outline(self):
        at, faces = self.loop_vertices, []
        for start, total in zip(self.starts, self.totals):
            faces.append(tuple(at[start:start + total]))
        used = set(at)
        vertices = self.vertices
        if len(used) != len(vertices):
            order = {v: i for i, v in enumerate(sorted(used))}
            vertices = [vertices[v] for v in order]
            faces = [tuple(order[v] for v in face) for face in faces]
        return Outline(vertices, faces, self._shared_normals())

    def _shared_normals(self):
        """For each face: smooth, and its corners have the normal of the smooth corners at the same vertices."""
        first, out = {}, []
        for start, total, smooth in zip(self.starts, self.totals, self.smooth):
            if smooth:
                for loop in range(start, start + total):
                    v, n = self.loop_vertices[loop], self.normals[loop]
                    m = first.setdefault(v, n)
                    if m is not n and dot(n, m) < 0.999:
                        smooth = False
                        break
            out.append(bool(smooth))
        return out


class MeshCache:
    """The MeshData of evaluated objects, read once for each mesh, however often it is instanced; one for equal meshes."""

    def __init__(self):
        self._found, self._equal, self._layers = {}, {}, {}

    def clear(self):
        """To be called when an object has another mesh: Blender may put it where a mesh was that is gone."""
        for known in (self._found, self._equal, self._layers):
            known.clear()

    def of(self, ob):
        """None for an object without faces."""
        if ob.type != "MESH" or ob.data is None:
            return _read_object(ob)
        key = ob.data.as_pointer()
        if key not in self._found:
            data = _read_object(ob)
            if data is not None and (equal := mesh_file.digest(data)) is not None:
                data = self._equal.setdefault(equal, data)
            self._found[key] = data
        return self._found[key]

    def layers_of(self, ob, look):
        """The Layers that a Look asks for, of an object with faces. They are no part of MeshData: equal meshes may differ in them."""
        if ob.type != "MESH":
            return _read_object(ob, lambda evaluated: mesh_layers.read(evaluated, look))
        key = ob.data.as_pointer(), look
        if key not in self._layers:
            self._layers[key] = _read_object(ob, lambda evaluated: mesh_layers.read(evaluated, look))
        return self._layers[key]


def _read_object(ob, read=None):
    read = read or (lambda copy: MeshData(copy, ob.data if ob.type == "MESH" else None))
    try:
        evaluated = ob.to_mesh()
    except RuntimeError:  # a curve that has no surface, for example
        return None
    try:
        return read(evaluated) if evaluated is not None and len(evaluated.polygons) else None
    finally:
        ob.to_mesh_clear()


def transformed(matrix, points):
    (a, b, c, d), (e, f, g, h), (i, j, k, l) = (tuple(row) for row in matrix[:3])
    return [(a * x + b * y + c * z + d, e * x + f * y + g * z + h, i * x + j * y + k * z + l) for x, y, z in points]


def cofactors(m):
    """(the transposed inverse times the determinant, the determinant) of the 3x3 part: what normals are mapped by."""
    (a, b, c), (d, e, f), (g, h, i) = (tuple(row)[:3] for row in m[:3])
    rows = ((e * i - f * h, f * g - d * i, d * h - e * g),
            (c * h - b * i, a * i - c * g, b * g - a * h),
            (b * f - c * e, c * d - a * f, a * e - b * d))
    return rows, a * rows[0][0] + b * rows[0][1] + c * rows[0][2]


class Normals(dict):
    """Texts of world-space normals by their value in the object's space; empty for one without a direction."""

    def __init__(self, matrix):
        super().__init__()
        self._rows, det = cofactors(matrix)
        self._sign = -1.0 if det < 0 else 1.0

    def __missing__(self, n):
        x, y, z = n
        (a, b, c), (d, e, f), (g, h, i) = self._rows
        nx, ny, nz = a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z
        length = math.sqrt(nx * nx + ny * ny + nz * nz)
        text = ""
        if length > 0 and math.isfinite(length):
            scale = self._sign / length
            text = "(%.6g,%.6g,%.6g)" % (nx * scale, ny * scale, nz * scale)
        self[n] = text
        return text


def triangle_lines(data, matrix, without=frozenset()):
    """(lines by slot, number of triangles left out): the mesh under a 4x4 world matrix as `triangle` blocks.

    Triangles without area and those with coordinates that glint cannot take are left out. Where the map mirrors, corners
    are reversed, so that fronts stay outside. `normals` are written only where they differ from the face's. without: slots whose
    triangles are written otherwise."""
    world = transformed(matrix, data.vertices)
    texts = ["(%.7g,%.7g,%.7g)" % p for p in world]
    normals = Normals(matrix)
    _, det = cofactors(matrix)
    mirrors = det < 0
    careful = not data.is_finite or det == 0 or max(map(abs, chain.from_iterable(world)), default=0) > MAX_COORDINATE
    lines, dropped = {}, 0
    corner_normals = data.normals
    for (a, b, c), (la, lb, lc), area, face, slot in zip(data.corners, data.loops, data.areas, data.face_normals,
                                                         data.slots):
        if not area > 0 and not careful or slot in without:
            continue
        if careful:
            points = world[a], world[b], world[c]
            if not all(abs(x) <= MAX_COORDINATE for p in points for x in p):  # false for NaN
                dropped += 1
                continue
            if not any(face_normal(points)):
                continue
        na, nb, nc = corner_normals[la], corner_normals[lb], corner_normals[lc]
        line = None
        if det != 0 and not (na == nb == nc and na[0] * face[0] + na[1] * face[1] + na[2] * face[2] > 1 - FLAT):
            ta, tb, tc = normals[na], normals[nb], normals[nc]
            if ta and tb and tc:
                if mirrors:
                    line = f"triangle{{vertices=({texts[c]},{texts[b]},{texts[a]}) normals=({tc},{tb},{ta})}}"
                else:
                    line = f"triangle{{vertices=({texts[a]},{texts[b]},{texts[c]}) normals=({ta},{tb},{tc})}}"
        if line is None:
            line = (f"triangle{{vertices=({texts[c]},{texts[b]},{texts[a]})}}" if mirrors
                    else f"triangle{{vertices=({texts[a]},{texts[b]},{texts[c]})}}")
        found = lines.get(slot)
        if found is None:
            lines[slot] = found = []
        found.append(line)
    return lines, dropped


def polygon_vertices(data, matrix):
    """The world-space corners of a mesh that is a single flat face without smooth normals; None if it is not one."""
    if len(data.totals) != 1 or not data.is_finite or not 4 <= data.totals[0] <= MAX_CORNERS:
        return None
    loops = range(data.starts[0], data.starts[0] + data.totals[0])
    local = [data.vertices[data.loop_vertices[i]] for i in loops]
    normal = face_normal(local)
    length = math.sqrt(sum(c * c for c in normal))
    if not length > 0:
        return None
    size = max(math.dist(p, local[0]) for p in local)
    if any(abs(dot(sub(p, local[0]), normal)) > 1e-6 * size * length for p in local):
        return None
    if any(dot(data.normals[i], normal) < (1 - FLAT) * length for i in loops):
        return None
    if not _is_convex(local, normal):
        return None
    _, det = cofactors(matrix)
    world = transformed(matrix, local)
    if det == 0 or not all(abs(c) <= MAX_COORDINATE for p in world for c in p):
        return None
    return [vector(p) for p in (reversed(world) if det < 0 else world)]


def _is_convex(points, normal):
    n = len(points)
    for i in range(n):
        u, v = sub(points[i], points[i - 1]), sub(points[(i + 1) % n], points[i])
        if not dot(cross(u, v), normal) > 0:
            return False
    return True
