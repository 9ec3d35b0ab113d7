# SPDX-License-Identifier: Apache-2.0
"""Objects of other packages, known by their attributes: atoms of ASE, Open Babel and MDAnalysis; meshes of trimesh, pyvista
and meshio. None of these packages is imported for that."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._elements import looks_of, numbers_of, numbers_of_symbols

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
    normals: Optional[Array]
    """(V, 3), or None."""
    colors: Optional[Array]
    """(V, 3) or (N, 3), or None."""
    values: Optional[Array]
    """(V,) or (N,), or None."""


def _is_trimesh_scene(item: Any) -> bool:
    """What trimesh.load() returns of many files."""
    return hasattr(item, "geometry") and hasattr(item, "dump")


def is_mesh(item: Any) -> bool:
    if _is_trimesh_scene(item):
        return True
    if hasattr(item, "vertices") and hasattr(item, "faces"):
        return True
    return hasattr(item, "points") and any(hasattr(item, name) for name in ("faces", "cells", "extract_surface"))


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


def _flat_faces(flat: Array) -> Array:
    """pyvista's: the number of corners before the corners of each face."""
    if len(flat) % 4 == 0 and (flat[::4] == 3).all():
        triangles: Array = flat.reshape(-1, 4)[:, 1:]
        return triangles
    faces, at = [], 0
    while at < len(flat):
        faces.append(flat[at + 1:at + 1 + flat[at]])
        at += 1 + int(flat[at])
    return triangle_faces(faces)


def _triangles(mesh: Any) -> Array:
    if hasattr(mesh, "vertices"):
        return triangle_faces(mesh.faces)
    if hasattr(mesh, "faces"):
        faces = np.asarray(mesh.faces, np.int64)
        return _flat_faces(faces) if faces.ndim == 1 else triangle_faces(faces)
    blocks = [np.zeros((0, 3), np.int64)]
    for block in mesh.cells:  # meshio's
        if str(block.type).startswith(("triangle", "quad", "polygon")):
            corners = {"triangle6": 3, "triangle7": 3, "quad8": 4, "quad9": 4}.get(str(block.type))
            blocks.append(triangle_faces([face[:corners] for face in block.data] if corners else block.data))
    if len(blocks) == 1:
        blocks = _boundary(mesh.cells)
    if not blocks:
        raise ValueError("the mesh has no triangles, quadrangles, polygons or cells with a volume")
    return np.concatenate(blocks)


# The faces of cells with a volume, counter-clockwise from outside, as VTK and meshio number their corners.
_FACES_OF_CELLS: Dict[str, List[Tuple[int, ...]]] = {
    "tetra": [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)],
    "pyramid": [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
    "wedge": [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)],
    "hexahedron": [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
}


def _boundary(cells: Any) -> List[Array]:
    """Triangles of the faces that one cell alone has."""
    found: Dict[int, List[Array]] = {}
    for block in cells:
        kind = str(block.type).rstrip("0123456789")  # tetra10: the first four are the corners
        for corners in _FACES_OF_CELLS.get(kind, []):
            found.setdefault(len(corners), []).append(np.asarray(block.data, np.int64)[:, list(corners)])
    outside = []
    for parts in found.values():
        faces = np.concatenate(parts)
        _, first, counts = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
        outside.append(triangle_faces(faces[np.sort(first[counts == 1])]))
    return outside


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
    triangles = _triangles(mesh)
    visual: Any = getattr(mesh, "visual", None)
    colors = None
    if getattr(visual, "kind", None) in ("vertex", "face"):
        colors = np.asarray(getattr(visual, f"{visual.kind}_colors"))[:, :3]
        if visual.kind == "face" and len(colors) != len(triangles):
            colors = None  # faces with more corners than three
    scalars = getattr(mesh, "active_scalars", None)
    is_known = scalars is not None and np.shape(scalars) in ((len(vertices),), (len(triangles),))
    values = np.asarray(scalars, float) if is_known else None
    return MeshArrays(vertices, triangles, _normals(mesh, vertices, triangles), colors, values)
