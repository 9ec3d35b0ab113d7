# SPDX-License-Identifier: Apache-2.0
"""Meshes as binary .ply files beside the scene, which glint reads without parsing numbers. Needs numpy; without it, and for
small meshes, mesh.py writes triangles into the text."""
import hashlib
from array import array

from .files import write_new

try:
    import numpy as np
except ImportError:  # Debian's Blender does not require it
    np = None

MIN_TRIANGLES = 1000
MAX_SHARED = 8  # vertices of the file at one place that corners share; each more takes a pass over the rest
MAX_CONDITION = 1e6  # of a transform; glint refuses 1e7


class MeshFiles:
    """Writes each mesh once, however often it is instanced and in however many frames: a file's name is the mesh's digest().

    folder: where; made when it is needed. shown: the folder's name in the scene's text."""

    def __init__(self, folder, shown):
        self.folder, self.shown = folder, shown

    def blocks_of(self, data, rows, layers):
        """(slot, name of the file) for each material of a mesh, or None if it belongs into the text.

        rows: the transform that it will have. layers: slot -> its Layers, for those that have some."""
        if np is None or len(data) < MIN_TRIANGLES or not data.is_finite or not _is_usable(rows):
            return None
        key = _digest_of_layers(layers)
        if key not in data.files:
            name = digest(data).hex()[:16] + key
            data.files[key] = [(slot, self._write(f"{name}_{slot}.ply" if slot else f"{name}.ply", content))
                               for slot, content in ply_by_slot(data, layers)]
        return data.files[key]

    def _write(self, name, content):
        write_new(self.folder, name, content)
        return f"{self.shown}/{name}"


def _is_usable(rows):
    """Whether glint takes this transform of a mesh: without each column's length, it is far from singular."""
    matrix = np.array(rows, float)[:3, :3]
    lengths = np.linalg.norm(matrix, axis=0)
    return bool(np.all(lengths > 0) and np.linalg.cond(matrix / lengths) < MAX_CONDITION)


def taken(values, numbers):
    """An array of the values with these numbers, both of int32."""
    return array("i", np.frombuffer(values, np.int32)[np.frombuffer(numbers, np.int32)].tobytes())


def sides(values):
    """(least, greatest) of each coordinate; NaN if one is NaN."""
    points = np.frombuffer(values, np.float32).reshape(-1, 3)
    return list(zip(points.min(0).tolist(), points.max(0).tolist()))


def digest(data):
    """A key of what a mesh looks like; None without numpy. Blender evaluates each copy of an object with a modifier by itself,
    and its threads give normals other last bits."""
    if np is None:
        return None
    key = hashlib.blake2b(digest_size=16)
    for values in (data.raw_vertices, data.loop_vertices, data.starts, data.totals, data.slots, data.smooth):
        key.update(values)
    key.update(np.round(np.frombuffer(data.raw_normals, np.float32) * 1000).astype(np.int16).tobytes())
    return key.digest()


def _digest_of_layers(layers):
    """Empty without layers."""
    if not layers:
        return ""
    key = hashlib.blake2b(digest_size=4)
    for slot, (uv, colors, _) in sorted(layers.items()):
        key.update(f"{slot} {uv is None} {colors is None}".encode())
        for values in (uv, colors):
            key.update(values or b"")
    return "_" + key.hexdigest()


def points(data, rows):
    """(x, y, z) of a mesh's vertices in the world, as arrays."""
    local = np.frombuffer(data.raw_vertices, np.float32).reshape(-1, 3).astype(float)
    return tuple((local @ np.array(rows, float)[:3, :3].T + np.array(rows, float)[:3, 3]).T)


def may_be_a_shape(data):
    """Whether looking for a sphere, a cylinder, a cone, a disc or a box is worth the time: vertices at one distance from the
    middle, or in the two end planes of an axis."""
    points = np.frombuffer(data.raw_vertices, np.float32).reshape(-1, 3)
    low, high = points.min(0), points.max(0)
    distances = np.linalg.norm(points - (low + high) / 2, axis=1)
    if distances.max() - distances.min() <= 1e-2 * distances.max():
        return True
    near = 1e-3 * (high - low).max()
    return bool((((points - low) <= near) | ((high - points) <= near)).all(0).any())


def ply_by_slot(data, layers):
    """(slot, bytes of a .ply) for each material slot that has triangles with an area. layers: slot -> its Layers."""
    vertices = np.frombuffer(data.raw_vertices, np.float32).reshape(-1, 3)
    at = np.frombuffer(data.loop_vertices, np.int32)  # of each corner of a face
    loops = np.frombuffer(data.raw_loops, np.int32).reshape(-1, 3)
    normals = np.frombuffer(data.raw_normals, np.float32).reshape(-1, 3)
    slots = np.frombuffer(data.slots, np.int32)
    has_area = np.frombuffer(data.areas, np.float32) > 0
    is_flat = _flat_triangles(normals, loops, np.frombuffer(data.raw_face_normals, np.float32).reshape(-1, 3))
    for slot in np.unique(slots):
        chosen = has_area & (slots == slot)
        if not chosen.any():
            continue
        if chosen.all():
            chosen = slice(None)  # copies nothing
        names, columns = [], []  # what the corners have, besides a place
        if not is_flat[chosen].all():
            names += ["nx", "ny", "nz"]
            columns.append(_normals_to_write(normals, at, loops[chosen], is_flat[chosen]))
        for values, some in zip(layers.get(int(slot), (None, None, ""))[:2], (["s", "t"], ["red", "green", "blue"])):
            if values is not None:
                names += some
                columns.append(np.frombuffer(values, np.float32).reshape(-1, len(some)))
        yield int(slot), _ply(vertices, at, loops[chosen], names, columns)


def _flat_triangles(normals, loops, faces):
    """For each triangle, whether all its corners have its normal."""
    is_flat = np.ones(len(loops), bool)
    for corner in loops.T:
        is_flat &= np.einsum("ij,ij->i", normals[corner], faces) > 1 - 1e-6
    return is_flat


def _normals_to_write(normals, at, loops, is_flat):
    """A normal for each corner of a face: its own where all corners at a vertex have one, and else (0, 0, 0), which they can share, for
    those of flat triangles alone."""
    if not is_flat.any():
        return normals
    one = np.zeros(int(at.max()) + 1, np.int32)
    one[at] = np.arange(len(at), dtype=np.int32)
    if np.array_equal(normals[one[at]], normals):
        return normals
    is_needed = np.zeros(len(normals), bool)
    is_needed[loops[~is_flat]] = True
    return np.where(is_needed[:, None], normals, np.float32(0))


def _ply(vertices, at, loops, names, columns):
    """columns: floats for each corner of a face, whose vertices are `at`; names: of all these."""
    if not columns:
        used, numbers = _used(at[loops], len(vertices))
        return _bytes(vertices[used], names, numbers)
    wanted = np.hstack(columns) if len(columns) > 1 else columns[0]
    chosen, rows = _shared(at, np.flatnonzero(_used(loops, len(at))[0]), wanted, len(vertices))
    return _bytes(np.hstack([vertices[at[chosen]], wanted[chosen]]), names, rows[loops])


def _shared(at, left, wanted, count):
    """(the corners that become a vertex of the file, for each corner the number of its vertex among these): one for each pair of a
    place and what the corners there have. left: the corners that matter; count: of places."""
    rows, first = np.zeros(len(at), np.int32), np.zeros(count, np.int32)
    chosen, number = [], 0
    for _ in range(MAX_SHARED):
        places = at[left]
        first[places] = left
        like = first[places]
        made = left[like == left]
        rows[made] = np.arange(number, number + len(made), dtype=np.int32)
        number += len(made)
        chosen.append(made)
        is_same = np.ones(len(left), bool)
        for column in wanted.T:
            is_same &= column[like] == column[left]
        is_same |= like == left  # a NaN is not equal to itself
        rows[left[is_same]] = rows[like[is_same]]
        left = left[~is_same]
        if not len(left):
            break
    rows[left] = np.arange(number, number + len(left), dtype=np.int32)
    return np.concatenate([*chosen, left]), rows


def _used(corners, count):
    """(which of so many are named, their numbers among these)"""
    used = np.zeros(count, bool)
    used[corners] = True
    return used, (np.cumsum(used, dtype=np.int32) - 1)[corners]


def _bytes(table, names, triangles):
    """names: of the table's columns after x, y and z."""
    header = "".join(["ply\nformat binary_little_endian 1.0\n", f"element vertex {len(table)}\n",
                      *(f"property float {name}\n" for name in ("x", "y", "z", *names)), f"element face {len(triangles)}\n",
                      "property list uchar int vertex_indices\nend_header\n"])
    faces = np.empty(len(triangles), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    return b"".join((header.encode(), np.ascontiguousarray(table, "<f4"), faces))
