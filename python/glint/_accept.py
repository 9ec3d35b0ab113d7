# SPDX-License-Identifier: Apache-2.0
"""Objects of other packages: atoms of ASE, meshes, matplotlib's colormaps. None of them is imported for that."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]


def is_atoms(item: Any) -> bool:
    return hasattr(item, "get_positions") and hasattr(item, "get_atomic_numbers")


def atom_arrays(atoms: Any) -> Tuple[Array, Array, Array]:
    """Positions, covalent radii (both in angstrom) and Jmol's colors of ASE's atoms."""
    numbers = atoms.get_atomic_numbers()
    if len(numbers) == 0:
        return np.zeros((0, 3)), np.zeros(0), np.zeros((0, 3))
    from ase.data import covalent_radii  # type: ignore[import]
    from ase.data.colors import jmol_colors  # type: ignore[import]

    return np.asarray(atoms.get_positions(), float), covalent_radii[numbers], jmol_colors[numbers]


def find_bonds(positions: Array, radii: Array, tolerance: float = 0.3) -> Array:
    """Pairs of atoms nearer than the sum of their covalent radii and the tolerance in angstrom: M x 2 indices."""
    if len(positions) == 0:
        return np.zeros((0, 2), np.int64)
    from scipy.spatial import cKDTree  # type: ignore[import]

    pairs = cKDTree(positions).query_pairs(2 * radii.max() + tolerance, output_type="ndarray")
    distances = np.linalg.norm(positions[pairs[:, 0]] - positions[pairs[:, 1]], axis=1)
    near: Array = pairs[distances < radii[pairs[:, 0]] + radii[pairs[:, 1]] + tolerance]
    return near


def is_mesh(item: Any) -> bool:
    return hasattr(item, "vertices") and hasattr(item, "faces")


def triangle_faces(faces: Any) -> Array:
    """Triangles of faces with any number of corners: fans from each face's first."""
    if len(faces) == 0:
        return np.zeros((0, 3), np.int64)
    try:
        array = np.asarray(faces, dtype=np.int64)
    except ValueError:  # faces of several sizes
        array = None
    if array is not None and array.ndim == 2:
        fans = [array[:, [0, i, i + 1]] for i in range(1, array.shape[1] - 1)]
        triangles: Array = np.stack(fans, axis=1).reshape(-1, 3)
        return triangles
    fan = [(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)]
    return np.asarray(fan, np.int64).reshape(-1, 3)


def mesh_arrays(mesh: Any) -> Tuple[Array, Array, Optional[Array]]:
    """Vertices (N x 3), triangles (M x 3) and, if the mesh has them, the vertices' normals."""
    vertices = np.asarray(mesh.vertices, float).reshape(-1, 3)
    normals = getattr(mesh, "normals", None)
    if normals is not None:
        normals = np.asarray(normals, float)
        if normals.shape != vertices.shape:
            normals = None
    return vertices, triangle_faces(mesh.faces), normals
