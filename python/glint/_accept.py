# SPDX-License-Identifier: Apache-2.0
"""Objects of other packages, known by their attributes: atoms of ASE, Open Babel and MDAnalysis; meshes of trimesh, pyvista
and meshio. None of these packages is imported for that."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._elements import looks_of, numbers_of, numbers_of_symbols
from ._polygons import Triangles, join, of_boundary, of_faces, of_flat_faces

Array = npt.NDArray[Any]


def _list_of_atoms(item: Any) -> Any:
    """Open Babel's atoms: those of a pybel.Molecule, or of an OBMol."""
    if hasattr(item, "NumAtoms") and hasattr(item, "GetAtom"):
        return [item.GetAtom(i + 1) for i in range(item.NumAtoms())]
    return item.atoms


def _is_group(item: Any) -> bool:
    """MDAnalysis: a Universe or an AtomGroup; not one Atom of ASE, which knows the Atoms that it is of."""
    atoms = getattr(item, "atoms", None)
    return hasattr(atoms, "positions") and not hasattr(atoms, "get_positions")


def _is_pair(item: Any) -> bool:
    """(symbols, positions)."""
    return isinstance(item, tuple) and len(item) == 2 and hasattr(item[0], "__len__") and np.shape(item[1])[1:] == (3,)


def is_atoms(item: Any) -> bool:
    if _is_pair(item):
        return True
    if hasattr(item, "get_positions") and hasattr(item, "get_atomic_numbers"):
        return True
    if hasattr(item, "NumAtoms") and hasattr(item, "GetAtom"):
        return True
    atoms: Any = getattr(item, "atoms", None)
    is_list = isinstance(atoms, (list, tuple))
    return _is_group(item) or (is_list and all(hasattr(a, "coords") and hasattr(a, "atomicnum") for a in atoms))


def atom_arrays(item: Any) -> Tuple[Array, Array, Array]:
    """Positions, covalent radii (both in angstrom) and Jmol's colors."""
    if _is_pair(item):
        if len(item[0]) != len(item[1]):
            raise ValueError(f"atoms: expected a symbol for each position, found {len(item[0])} and {len(item[1])}")
        positions, numbers = item[1], numbers_of_symbols(item[0])
    elif hasattr(item, "get_positions"):
        positions, numbers = item.get_positions(), item.get_atomic_numbers()
    elif _is_group(item):
        positions = item.atoms.positions
        symbols, *words = (getattr(item.atoms, name, None) for name in ("elements", "types", "names"))
        known = [of_atoms for of_atoms in words if of_atoms is not None]
        numbers = numbers_of(known[0]) if known else [0] * len(positions)
        if symbols is not None:  # 'Cd' is no carbon then
            numbers = [of_symbol or number for of_symbol, number in zip(numbers_of_symbols(symbols), numbers)]
    else:
        atoms = _list_of_atoms(item)
        if hasattr(item, "NumAtoms"):
            positions = [(a.GetX(), a.GetY(), a.GetZ()) for a in atoms]
            numbers = [a.GetAtomicNum() for a in atoms]
        else:
            positions, numbers = [a.coords for a in atoms], [a.atomicnum for a in atoms]
    places = np.asarray(positions, float).reshape(-1, 3)
    if len(places) > 1 and (places == places[0]).all():
        raise ValueError(f"atoms: all {len(places)} are at {tuple(places[0].tolist())}; Open Babel's make3D() gives them places")
    return places, *looks_of(numbers)


def find_bonds(positions: Array, radii: Array, tolerance: float = 0.3) -> Array:
    """Pairs of atoms nearer than the sum of their covalent radii and the tolerance in angstrom: M x 2 indices."""
    if len(positions) < 2:
        return np.zeros((0, 2), np.int64)
    reach = 2 * radii.max() + tolerance
    try:
        from scipy.spatial import cKDTree  # type: ignore[import]

        pairs = cKDTree(positions).query_pairs(reach, output_type="ndarray")
    except ImportError:
        pairs = _near_pairs(positions, reach)
    distances = np.linalg.norm(positions[pairs[:, 0]] - positions[pairs[:, 1]], axis=1)
    near: Array = pairs[distances < radii[pairs[:, 0]] + radii[pairs[:, 1]] + tolerance]
    return near


def _near_pairs(positions: Array, reach: float) -> Array:
    """Pairs whose x differ by less than reach, without scipy."""
    order = np.argsort(positions[:, 0], kind="stable")
    x = positions[order, 0]
    ends = np.searchsorted(x, x + reach)
    pairs: List[Array] = [np.zeros((0, 2), np.int64)]
    for i, end in enumerate(ends):
        others = order[i + 1:end]
        near = others[np.abs(positions[others] - positions[order[i]]).max(axis=1, initial=0.0) < reach]
        pairs.append(np.column_stack([np.full(len(near), order[i]), near]))
    return np.concatenate(pairs)


class MeshArrays(NamedTuple):
    vertices: Array
    triangles: Array
    owners: Array
    """(N,): which of the mesh's faces, or of its cells with a volume, each triangle is of."""
    owner_count: int
    normals: Optional[Array]
    """(V, 3), or None."""
    colors: Optional[Array]
    """(V, 3), or of the triangles or the faces, or None."""
    values: Optional[Array]
    """(V,), or of the triangles or the faces, or None."""


def _is_trimesh_scene(item: Any) -> bool:
    """What trimesh.load() returns of many files."""
    return hasattr(item, "geometry") and hasattr(item, "dump")


def is_mesh(item: Any) -> bool:
    if _is_trimesh_scene(item):
        return True
    if hasattr(item, "vertices") and hasattr(item, "faces"):
        return True
    return hasattr(item, "points") and any(hasattr(item, name) for name in ("faces", "cells", "extract_surface"))


def _triangles(mesh: Any) -> Triangles:
    if hasattr(mesh, "vertices"):
        return of_faces(mesh.faces)
    if hasattr(mesh, "faces"):
        faces = np.asarray(mesh.faces, np.int64)
        return of_flat_faces(faces) if faces.ndim == 1 else of_faces(faces)
    blocks = []
    for block in mesh.cells:  # meshio's
        if str(block.type).startswith(("triangle", "quad", "polygon")):
            corners = {"triangle6": 3, "triangle7": 3, "quad8": 4, "quad9": 4}.get(str(block.type))
            blocks.append(of_faces([face[:corners] for face in block.data] if corners else block.data))
    found = join(blocks) if blocks else of_boundary(mesh.cells)
    if not len(found.corners):
        raise ValueError("the mesh has no triangles, quadrangles, polygons or cells with a volume")
    return found


def _normals(mesh: Any, vertices: Array, triangles: Array) -> Optional[Array]:
    for name in ("vertex_normals", "normals", "point_normals"):
        given = getattr(mesh, name, None)
        if given is None or callable(given):
            continue
        normals = np.array(given, float)
        if normals.shape == vertices.shape:
            zero = ~normals.any(axis=1) | ~np.isfinite(normals).all(axis=1)
            if zero[triangles].any():
                return None
            normals[zero] = (0, 0, 1)  # of vertices that no triangle has
            return normals
    return None


def mesh_arrays(mesh: Any) -> MeshArrays:
    """A mesh of trimesh, pyvista or meshio, or of any class with the same attributes."""
    if _is_trimesh_scene(mesh):
        mesh = mesh.to_mesh() if hasattr(mesh, "to_mesh") else mesh.dump(concatenate=True)
    if not hasattr(mesh, "vertices") and not hasattr(mesh, "faces") and hasattr(mesh, "extract_surface"):
        mesh = mesh.extract_surface()
    points = mesh.vertices if hasattr(mesh, "vertices") else mesh.points
    vertices = np.asarray(points, float)
    if vertices.ndim == 2 and vertices.shape[1] == 2:
        vertices = np.pad(vertices, ((0, 0), (0, 1)))
    vertices = vertices.reshape(-1, 3)
    triangles, owners, owner_count = _triangles(mesh)
    visual: Any = getattr(mesh, "visual", None)
    colors = None
    if getattr(visual, "kind", None) in ("vertex", "face"):
        colors = np.asarray(getattr(visual, f"{visual.kind}_colors"))[:, :3]
    scalars = getattr(mesh, "active_scalars", None)
    is_known = scalars is not None and np.shape(scalars) in ((len(vertices),), (len(triangles),), (owner_count,))
    values = np.asarray(scalars, float) if is_known else None
    return MeshArrays(vertices, triangles, owners, owner_count, _normals(mesh, vertices, triangles), colors, values)
