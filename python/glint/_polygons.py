# SPDX-License-Identifier: Apache-2.0
"""Triangles of faces with more corners, and of the outside of cells with a volume."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Tuple

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.int64]


class Triangles(NamedTuple):
    corners: Numbers
    """(N, 3), numbers of vertices."""
    owners: Numbers
    """(N,): which face, or which cell, each is of."""
    owner_count: int


def join(parts: List[Triangles]) -> Triangles:
    """Of several lists of faces, which are numbered one after the other."""
    before = np.cumsum([0] + [part.owner_count for part in parts])
    return Triangles(
        np.concatenate([part.corners for part in parts]),
        np.concatenate([part.owners + first for part, first in zip(parts, before)]),
        int(before[-1]),
    )


def of_faces(faces: Any) -> Triangles:
    """Of faces with any number of corners: fans from each face's first."""
    count = len(faces)
    if count == 0:
        return Triangles(np.zeros((0, 3), np.int64), np.zeros(0, np.int64), 0)
    try:
        array = np.asarray(faces, dtype=np.int64)
    except ValueError:  # faces of several sizes
        array = None
    if array is not None and array.ndim == 2:
        fans = [array[:, [0, i, i + 1]] for i in range(1, array.shape[1] - 1)]
        return Triangles(np.stack(fans, axis=1).reshape(-1, 3), np.repeat(np.arange(count), len(fans)), count)
    fan = [(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)]
    owners = np.repeat(np.arange(count), [max(0, len(face) - 2) for face in faces])
    return Triangles(np.asarray(fan, np.int64).reshape(-1, 3), owners, count)


def of_flat_faces(flat: Numbers) -> Triangles:
    """pyvista's: the number of corners before the corners of each face."""
    if len(flat) % 4 == 0 and (flat[::4] == 3).all():
        return of_faces(flat.reshape(-1, 4)[:, 1:])
    faces, at = [], 0
    while at < len(flat):
        faces.append(flat[at + 1:at + 1 + flat[at]])
        at += 1 + int(flat[at])
    return of_faces(faces)


# The faces of cells with a volume, counter-clockwise from outside, as VTK and meshio number their corners.
_FACES_OF_CELLS: Dict[str, List[Tuple[int, ...]]] = {
    "tetra": [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)],
    "pyramid": [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
    "wedge": [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)],
    "hexahedron": [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
}


def of_boundary(cells: Any) -> Triangles:
    """Of the faces that one cell alone has; none if no cell has a volume. cells: meshio's blocks."""
    found: Dict[int, List[Tuple[Numbers, Numbers]]] = {}
    count = 0
    for block in cells:
        kind = str(block.type).rstrip("0123456789")  # tetra10: the first four are the corners
        if kind not in _FACES_OF_CELLS:
            continue
        data = np.asarray(block.data, np.int64)
        numbers = np.arange(count, count + len(data))
        count += len(data)
        for corners in _FACES_OF_CELLS[kind]:
            found.setdefault(len(corners), []).append((data[:, list(corners)], numbers))
    triangles, owners = [np.zeros((0, 3), np.int64)], [np.zeros(0, np.int64)]
    for parts in found.values():
        faces, of_cells = (np.concatenate(arrays) for arrays in zip(*parts))
        _, first, uses = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
        outside = np.sort(first[uses == 1])
        fans = of_faces(faces[outside])
        triangles.append(fans.corners)
        owners.append(of_cells[outside][fans.owners])
    return Triangles(np.concatenate(triangles), np.concatenate(owners), count)
