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
    for values in (data.raw_vertices, data.raw_corners, data.raw_loops, data.slots, data.smooth):
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
    corners = np.frombuffer(data.raw_corners, np.int32).reshape(-1, 3)
    loops = np.frombuffer(data.raw_loops, np.int32).reshape(-1, 3)
    normals = np.frombuffer(data.raw_normals, np.float32).reshape(-1, 3)
    faces = np.frombuffer(data.raw_face_normals, np.float32).reshape(-1, 3)
    slots = np.frombuffer(data.slots, np.int32)
    has_area = np.frombuffer(data.areas, np.float32) > 0
    # Flat: all corners have the face's normal. glint takes (0, 0, 0) for it.
    at_corners = normals[loops]
    is_flat = ((at_corners * faces[:, None, :]).sum(2) > 1 - 1e-6).all(1)
    for slot in np.unique(slots):
        chosen = has_area & (slots == slot)
        if not chosen.any():
            continue
        if chosen.all():
            chosen = slice(None)  # copies nothing
        names, columns = [], []  # what the corners have, besides a place
        if not is_flat[chosen].all():
            names += ["nx", "ny", "nz"]
            columns.append(_normals_to_write(corners[chosen], at_corners[chosen], is_flat[chosen], len(vertices)))
        for values, some in zip(layers.get(int(slot), (None, None, ""))[:2], (["s", "t"], ["red", "green", "blue"])):
            if values is not None:
                names += some
                columns.append(np.frombuffer(values, np.float32).reshape(-1, len(some))[loops[chosen].reshape(-1)])
        yield int(slot), _ply(vertices, corners[chosen], names, columns)


def _normals_to_write(corners, at_corners, is_flat, count):
    """A normal for each corner: its own where all corners at a vertex have one, and else (0, 0, 0), which they can share, for those of
    flat triangles."""
    own, at = at_corners.reshape(-1, 3), corners.reshape(-1)
    first = np.zeros((count, 3), np.float32)
    first[at] = own
    return own if np.array_equal(first[at], own) else np.where(is_flat[:, None, None], np.float32(0), at_corners).reshape(-1, 3)


def _ply(vertices, corners, names, columns):
    if not columns:
        used, numbers = _used(corners, len(vertices))
        return _bytes(vertices[used], names, numbers)
    wanted = np.hstack(columns) if len(columns) > 1 else columns[0]
    at = corners.reshape(-1)
    # A vertex for each pair of a place and what its corners have: at most places, all corners have the same.
    first = np.zeros((len(vertices), wanted.shape[1]), np.float32)
    first[at] = wanted
    is_split = np.zeros(len(vertices), bool)
    for ours, theirs in zip(first[at].T, wanted.T):
        is_split[at[ours != theirs]] = True
    splits = is_split[at]
    used, numbers = _used(at, len(vertices), is_split)
    table = [np.hstack([vertices[used], first[used]])]
    if splits.any():
        some = wanted[splits]
        index, new = _distinct(np.hstack([at[splits][:, None], np.ascontiguousarray(some).view(np.int32)]))
        numbers[splits] = len(table[0]) + new
        table.append(np.hstack([vertices[at[splits][index]], some[index]]))
    return _bytes(np.concatenate(table), names, numbers.reshape(-1, 3))


def _distinct(rows):
    """(the numbers of rows that differ from all others of these, for each row which of them it is). Rows are compared by a hash,
    which is much faster than by their numbers; should two rows have the same hash, they are compared by these."""
    keys = np.zeros(len(rows), np.uint64)
    for column in rows.T:
        keys = (keys ^ column.astype(np.uint32)) * np.uint64(0x9E3779B97F4A7C15)
        keys ^= keys >> np.uint64(29)
    _, index, numbers = np.unique(keys, return_index=True, return_inverse=True)
    if not np.array_equal(rows[index][numbers], rows):
        _, index, numbers = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return index, numbers.reshape(-1)


def _used(corners, count, without=False):
    """(which of the vertices have a triangle and are not `without`, the corners' numbers among these)"""
    used = np.zeros(count, bool)
    used[corners] = True
    used &= ~np.asarray(without)
    return used, (np.cumsum(used, dtype=np.int32) - 1)[corners]


def _bytes(table, names, triangles):
    """names: of the table's columns after x, y and z."""
    header = "".join(["ply\nformat binary_little_endian 1.0\n", f"element vertex {len(table)}\n",
                      *(f"property float {name}\n" for name in ("x", "y", "z", *names)), f"element face {len(triangles)}\n",
                      "property list uchar int vertex_indices\nend_header\n"])
    faces = np.empty(len(triangles), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    return header.encode() + table.astype("<f4").tobytes() + faces.tobytes()
