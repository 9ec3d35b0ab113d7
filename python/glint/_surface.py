# SPDX-License-Identifier: Apache-2.0
"""Meshes of grids of points: height fields, and surfaces of two parameters."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import numpy.typing as npt

from ._expect import shown

Floats = npt.NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class Surface:
    """What surface() returns: a mesh for Scene.add(), Scene.mesh() and glint.show()."""

    vertices: Floats
    """(V, 3), row by row of the grid."""
    faces: npt.NDArray[np.int64]
    """(N, 3): two triangles for each cell of the grid."""
    vertex_normals: Floats
    """(V, 3), unit vectors."""


def surface(x: Any, y: Any, z: Any) -> Surface:
    """The mesh of a grid of points: a height field z of x and y, or any surface x, y, z of two parameters.

    x, y, z: (rows, columns) of numbers, or what NumPy broadcasts to that, such as x of (columns,) and y of (rows, 1).
    scene.add(surface(x, y, z), values=z, colormap='viridis') colors it: values are of (rows, columns) or flat. Normals are
    smooth, also where the first and the last row or column are the same points. ValueError if there is no such grid.
    """
    try:
        grids = np.broadcast_arrays(*(np.asarray(axis, float) for axis in (x, y, z)))
    except (TypeError, ValueError):
        sizes = ", ".join(" x ".join(map(str, np.shape(axis))) or shown(axis) for axis in (x, y, z))
        raise ValueError(f"x, y, z: expected grids of one size, found {sizes}") from None
    points = np.stack(grids, axis=-1)
    if points.ndim != 3 or min(points.shape[:2]) < 2:
        sizes = " x ".join(map(str, points.shape[:-1])) or "one number"
        raise ValueError(f"x, y, z: expected grids of at least 2 x 2 numbers, found {sizes}")
    unknown = np.argwhere(~np.isfinite(points))
    if len(unknown):
        row, column, axis = unknown[0]
        raise ValueError(f"{'xyz'[axis]}: row {row}, column {column}: expected a number, found {points[row, column, axis]}")
    numbers = np.arange(points[..., 0].size).reshape(points.shape[:2])
    a, b, c, d = numbers[:-1, :-1], numbers[:-1, 1:], numbers[1:, 1:], numbers[1:, :-1]
    faces = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return Surface(points.reshape(-1, 3), faces, _normals(points))


def _normals(points: Floats) -> Floats:
    """The mean of the normals of the cells around each point."""
    a, b, c, d = points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]
    of_cells = _unit(np.cross(c - a, d - b))
    normals = np.zeros_like(points)
    for corner in (normals[:-1, :-1], normals[:-1, 1:], normals[1:, 1:], normals[1:, :-1]):
        corner += of_cells
    near = 1e-9 * float(np.ptp(points, axis=(0, 1)).max())
    for axis in (0, 1):
        lines, sums = np.moveaxis(points, axis, 0), np.moveaxis(normals, axis, 0)
        if (np.abs(lines[0] - lines[-1]) <= near).all():  # closed
            sums[0] += sums[-1]
            sums[-1] = sums[0]
        for end in (0, -1):
            if (np.abs(lines[end] - lines[end][0]) <= near).all():  # a pole
                sums[end] = sums[end].sum(axis=0)
    return _unit(normals).reshape(-1, 3)


def _unit(vectors: Floats) -> Floats:
    """Of length 1, or 0 where it was that."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    unit: Floats = np.divide(vectors, lengths, out=np.zeros_like(vectors), where=lengths > 0)
    return unit
