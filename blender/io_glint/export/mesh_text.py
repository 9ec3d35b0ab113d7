# SPDX-License-Identifier: Apache-2.0
"""Small meshes with UV maps or colors as `mesh` blocks in the text."""
from . import mesh, text


def mesh_blocks(data, matrix, by_slot, title):
    """(blocks, number of triangles left out): for each slot, one `mesh` under a 4x4 world matrix.

    by_slot: slot -> (the material's name, Layers). title: the name of the blocks. Triangles that glint cannot take are left out."""
    world = mesh.transformed(matrix, data.vertices)
    _, det = mesh.cofactors(matrix)
    normals = mesh.Normals(matrix)
    chosen, dropped = {slot: [] for slot in by_slot}, 0
    for i, slot in enumerate(data.slots):
        if slot not in chosen:
            continue
        points = [world[v] for v in data.corners[i]]
        if not all(abs(x) <= mesh.MAX_COORDINATE for p in points for x in p):  # false for NaN
            dropped += 1
        elif any(mesh.face_normal(points)):
            chosen[slot].append(i)
    return [_block(data, by_slot[slot], triangles, world, normals, det, title) for slot, triangles in chosen.items() if triangles], dropped


def _block(data, named, triangles, world, normals, det, title):
    name, layers = named
    numbers, numbered = {}, []
    for i in triangles:
        face, loops = data.face_normals[i], data.loops[i]
        at_corners = [data.normals[k] for k in loops]
        is_flat = det == 0 or all(n[0] * face[0] + n[1] * face[1] + n[2] * face[2] > 1 - mesh.FLAT for n in at_corners)
        order = (2, 1, 0) if det < 0 else (0, 1, 2)  # fronts stay outside
        corners = []
        for j in order:
            normal = "" if is_flat else normals[at_corners[j]]
            key = (data.corners[i][j], normal or "(0,0,0)", _part(layers.uv, loops[j], 2), _part(layers.colors, loops[j], 3))
            corners.append(numbers.setdefault(key, len(numbers)))
        numbered.append(corners)
    keys = list(numbers)
    entries = [("vertices", _list("(%.7g,%.7g,%.7g)" % world[key[0]] for key in keys)),
               ("triangles", _list("(%d,%d,%d)" % tuple(corners) for corners in numbered))]
    if any(key[1] != "(0,0,0)" for key in keys):
        entries.append(("normals", _list(key[1] for key in keys)))
    if layers.uv is not None:
        entries.append(("texture_coordinates", _list("(%.7g,%.7g)" % key[2] for key in keys)))
    if layers.colors is not None:
        entries.append(("colors", _list("(%.7g,%.7g,%.7g)" % key[3] for key in keys)))
    return text.block("mesh", title, [*entries, ("material", text.string(name))])


def _part(values, loop, width):
    return tuple(values[width * loop:width * (loop + 1)]) if values is not None else ()


def _list(texts):
    return f"({','.join(texts)})"
