# SPDX-License-Identifier: Apache-2.0
"""The scene's functions that add many shapes at once, from arrays and from objects of other packages."""

from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np

from . import _accept, _glint
from ._classes import check_normals
from ._colors import Colormap, ColorScale, Norm, colors_of
from ._expect import Closed, plain, shown
from ._glint import Material, Mesh
from ._surface import Surface
from ._values import ColorLike

Arrays = Any
"""Numbers as NumPy arrays or what NumPy makes arrays of."""


def rows_of(array: Any) -> Optional[int]:
    """How many rows there are; None of what is no array, which is refused elsewhere."""
    try:
        return len(array)
    except TypeError:
        return None


def _check_ends(from_: Any, to: Any) -> None:
    """Refuses cylinders without an axis; the extension module refuses what are no points at all."""
    try:
        starts, ends = np.asarray(from_, float), np.asarray(to, float)
        equal = np.flatnonzero((starts == ends).all(axis=-1)) if starts.shape == ends.shape else np.zeros(0)
    except (TypeError, ValueError):
        return
    if equal.size and starts.ndim == 2:
        raise ValueError(f"to: row {equal[0]}: expected another point than that of from_, found {tuple(ends[equal[0]].tolist())}")


class ManyShapes(Closed):
    """A part of Scene."""

    _state: _glint.SceneState

    @plain
    def spheres(
        self,
        centers: Arrays,
        radii: Arrays = 1.0,
        colors: Any = None,
        *,
        material: Optional[Material] = None,
        values: Any = None,
        colormap: Union[None, Colormap, ColorScale] = None,
        vmin: Optional[float] = None,
        vmax: Optional[float] = None,
        norm: Norm = None,
        nan_color: ColorLike = 0.5,
    ) -> range:
        """Adds N spheres and returns the range of their numbers.

        centers: (N, 3), in the scene's units; radii: one number or (N,), > 0; colors: one color, (N, 3) or N
        names, or None for the material's; of uint8, 255 is 1. material: what all have but for the color. (N, 3)
        colors become those of the shapes (shape.color), in single precision.

        values: (N,), which a scale makes colors: colormap is matplotlib's, its name, or a ColorScale; vmin and
        vmax are the ends of its range, by default of the values; norm is 'linear', 'log' or matplotlib's. NaN has
        the color nan_color and does not count for the range, as infinity does not; a GlintWarning says how many
        there are. colors with colormap= and without values are the values.
        """
        given = colors_of(colors, values, colormap, vmin, vmax, norm, nan_color, rows_of(centers))
        return self._state.add_spheres(centers, radii, given, material)

    @plain
    def cylinders(
        self,
        from_: Arrays,
        to: Arrays,
        radii: Arrays = 1.0,
        colors: Any = None,
        *,
        material: Optional[Material] = None,
        values: Any = None,
        colormap: Union[None, Colormap, ColorScale] = None,
        vmin: Optional[float] = None,
        vmax: Optional[float] = None,
        norm: Norm = None,
        nan_color: ColorLike = 0.5,
        caps: bool = True,
    ) -> range:
        """Adds N cylinders between points (N, 3) and (N, 3). caps: their ends are closed. See spheres()."""
        _check_ends(from_, to)
        given = colors_of(colors, values, colormap, vmin, vmax, norm, nan_color, rows_of(from_))
        return self._state.add_cylinders(from_, to, radii, given, material, caps)

    @plain
    def triangles(
        self,
        vertices: Arrays,
        faces: Optional[Arrays] = None,
        colors: Any = None,
        *,
        normals: Optional[Arrays] = None,
        material: Optional[Material] = None,
        values: Any = None,
        colormap: Union[None, Colormap, ColorScale] = None,
        vmin: Optional[float] = None,
        vmax: Optional[float] = None,
        norm: Norm = None,
        nan_color: ColorLike = 0.5,
    ) -> range:
        """Adds N triangles: vertices (N, 3, 3), or vertices (V, 3) and their indices, faces (N, 3).

        normals: of the vertices, in the same form, for smooth shading. colors: one, or (N, 3). See spheres().
        """
        if normals is not None:
            check_normals(normals)
        count = rows_of(vertices if faces is None else faces)
        given = colors_of(colors, values, colormap, vmin, vmax, norm, nan_color, count)
        return self._state.add_triangles(vertices, faces, normals, given, material)

    @plain
    def add_mesh(
        self,
        vertices: Arrays,
        faces: Arrays,
        *,
        normals: Optional[Arrays] = None,
        colors: Any = None,
        values: Any = None,
        colormap: Union[None, Colormap, ColorScale] = None,
        vmin: Optional[float] = None,
        vmax: Optional[float] = None,
        norm: Norm = None,
        nan_color: ColorLike = 0.5,
        texture_coordinates: Optional[Arrays] = None,
        material: Optional[Material] = None,
        transform: Any = None,
        name: str = "",
    ) -> Mesh:
        """Adds triangles with common vertices as one shape, and returns it.

        vertices: (V, 3), kept as float32 if they are that, else as float64; faces: (N, 3), the numbers of the
        vertices, counter-clockwise around the normal. normals: (V, 3), of any length, for smooth shading;
        colors: (V, 3), linear, which are interpolated; of uint8, 255 is 1. The material's own color is used without
        them. values: (V,), which become colors of the vertices, as for spheres().
        texture_coordinates: (V, 2), u and v of the material's texture, interpolated; u goes to the right and v up,
        and (0, 0) is the lower left corner of the picture. A
        mesh of which a scene has many copies is stored once: add(glint.Mesh(...)) again, or copies of it with
        other transforms.
        ValueError names the row of a number beyond 1e12, or of a face without three vertices of the list.
        """
        given = colors_of(colors, values, colormap, vmin, vmax, norm, nan_color, rows_of(vertices))
        mesh = Mesh(vertices, faces, normals, given, texture_coordinates, name=name)
        if material is not None:
            mesh.material = material
        if transform is not None:
            mesh.transform = transform
        self._state.add_shape(mesh)
        return mesh

    @plain
    def mesh(
        self,
        mesh: Any,
        colors: Any = None,
        *,
        values: Any = None,
        colormap: Union[None, Colormap, ColorScale] = None,
        vmin: Optional[float] = None,
        vmax: Optional[float] = None,
        norm: Norm = None,
        nan_color: ColorLike = 0.5,
        material: Optional[Material] = None,
        smooth: bool = True,
    ) -> range:
        """Adds a glint.surface(), a mesh of trimesh, pyvista or meshio, or any object with `vertices` and `faces` of three
        or more corners.

        colors: one, (N, 3) of triangles, faces or cells, or (V, 3) of vertices, which are interpolated; by default those of
        trimesh's `visual`. values: (N,) or (V,), as for spheres(); by default pyvista's `active_scalars`. Where there are as many
        triangles as vertices, they are of the triangles. Of a surface(), both are of its grid. smooth: by the mesh's normals of vertices, if it has them.
        Returns the range of the shapes' numbers: triangles, or one Mesh if there are colors of vertices.
        """
        if not _accept.is_mesh(mesh):
            raise TypeError(f"mesh: expected an object with vertices and faces, found {shown(mesh)}")
        found = _accept.mesh_arrays(mesh)
        normals = found.normals if smooth else None
        if colors is None and values is None:
            colors, values = found.colors, found.values if found.colors is None else None
        if isinstance(mesh, Surface):
            values = None if values is None else np.ravel(values)
            colors = np.reshape(colors, (-1, 3)) if np.ndim(colors) == 3 else colors
        each = colors if values is None else values
        count = rows_of(each) if each is not None and not isinstance(each, str) and np.ndim(each) else None
        # Three numbers are one color.
        is_list = bool(count) and (values is not None or colormap is not None or np.ndim(each) == 2 or isinstance(each[0], str))
        if is_list and count == found.owner_count and count not in (len(found.vertices), len(found.triangles)):
            # From the faces to their triangles.
            if values is None:
                colors = [colors[owner] for owner in found.owners]
            else:
                masked: Any = np.ma  # has no types
                values = masked.asarray(values)[found.owners]
            count = len(found.triangles)
        is_of_vertices = count == len(found.vertices) and (isinstance(mesh, Surface) or count != len(found.triangles))
        if is_list and is_of_vertices:
            given = colors_of(colors, values, colormap, vmin, vmax, norm, nan_color, count)
            self.add_mesh(found.vertices, found.triangles, normals=normals, colors=given, material=material)
            return range(self._state.shape_count() - 1, self._state.shape_count())
        return self.triangles(
            found.vertices,
            found.triangles,
            colors,
            values=values,
            colormap=colormap,
            vmin=vmin,
            vmax=vmax,
            norm=norm,
            nan_color=nan_color,
            normals=normals,
            material=material,
        )

    @plain
    def atoms(
        self,
        atoms: Any,
        *,
        scale: float = 0.5,
        bonds: Union[bool, Arrays] = True,
        bond_radius: float = 0.12,
        bond_color: ColorLike = (0.6, 0.6, 0.6),
        material: Optional[Material] = None,
    ) -> range:
        """Adds the atoms of ASE, Open Babel or MDAnalysis, or (symbols, positions), such as ("OHH", array): a sphere
        of `scale` times the covalent radius for each, in Jmol's colors.

        bonds: cylinders between atoms that are near enough, or pairs (M, 2) of indices, or False. Lengths are
        in angstrom. Symbols may be atomic numbers, and positions are (N, 3). Without ASE, radii and colors of rare elements are 1.2 and pink. Returns the range of the atoms' numbers.
        """
        if not _accept.is_atoms(atoms):
            raise TypeError(f"atoms: expected atoms of ASE, Open Babel or MDAnalysis, or (symbols, positions), found {shown(atoms)}")
        positions, radii, colors = _accept.atom_arrays(atoms)
        added = self.spheres(positions, scale * radii, colors, material=material)
        if bonds is not False:
            pairs = _accept.find_bonds(positions, radii) if bonds is True else np.asarray(bonds)
            if len(pairs):
                ends = positions[pairs[:, 0]], positions[pairs[:, 1]]
                self.cylinders(*ends, bond_radius, bond_color, material=material, caps=False)
        return added
