# SPDX-License-Identifier: Apache-2.0
"""Objects of other packages, as stand-ins with their attributes."""

from types import SimpleNamespace as Stand

import numpy as np
import pytest

import glint
from glint import _accept

POSITIONS = np.array([(0, 0, 0), (0.96, 0, 0), (-0.24, 0.93, 0)])
VERTICES = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float)
TRIANGLES = np.array([(0, 1, 2), (0, 2, 3)])
UP = np.tile((0.0, 0.0, 1.0), (4, 1))


class OBMol:
    def NumAtoms(self):
        return 3

    def GetAtom(self, i):
        x, y, z = POSITIONS[i - 1]
        return Stand(GetX=lambda: x, GetY=lambda: y, GetZ=lambda: z, GetAtomicNum=lambda: (8, 1, 1)[i - 1])


class Atoms:
    def get_positions(self):
        return POSITIONS

    def get_atomic_numbers(self):
        return np.array([8, 1, 1])


GROUP = Stand(positions=POSITIONS.astype(np.float32), elements=np.array(["O", "H", "H"]))
NAMED = Stand(positions=POSITIONS, names=np.array(["OW", "HW1", "HW2"]))
MOLECULES = {
    "ase": Atoms(),
    "OBMol": OBMol(),
    "pybel": Stand(atoms=[Stand(coords=tuple(p), atomicnum=n) for p, n in zip(POSITIONS, (8, 1, 1))]),
    "MDAnalysis": Stand(atoms=GROUP),
    "MDAnalysis names": Stand(atoms=NAMED),
    "symbols": (["o", "H", 1], POSITIONS.tolist()),
    "letters": ("OHH", POSITIONS),
}


@pytest.mark.parametrize("name", MOLECULES)
def test_molecules(name):
    scene = glint.show(MOLECULES[name], size=(40, 30), background="black")
    assert len(scene.shapes) == 5  # and two bonds
    oxygen, hydrogen = scene.shapes[0], scene.shapes[1]
    assert oxygen.center == (0, 0, 0) and oxygen.radius == pytest.approx(0.33)
    assert oxygen.color.r > 0.9 and oxygen.color.g < 0.1 and hydrogen.color == (1, 1, 1)
    assert hydrogen.center == pytest.approx((0.96, 0, 0))
    image = scene.render()
    assert image.array.max() > 0.5 and image.array[0].max() == 0


def test_elements_are_symbols_and_names_are_not():
    elements = Stand(positions=POSITIONS, elements=np.array(["Ca", "Xx", ""]), names=np.array(["O", "O", "O1"]))
    colors = [glint.show(Stand(atoms=elements), bonds=False).shapes[i].color for i in range(3)]
    calcium, oxygen = (glint.show(([symbol], [(0, 0, 0)])).shapes[0].color for symbol in ("Ca", "O"))
    assert colors == [calcium, oxygen, oxygen]


def test_bonds_without_scipy_are_those_of_all_pairs():
    points = np.random.default_rng(2).random((60, 3))
    pairs = {tuple(sorted(pair)) for pair in _accept._near_pairs(points, 0.3).tolist()}
    near = np.abs(points[:, None] - points[None]).max(axis=2) < 0.3
    assert pairs == {(i, j) for i in range(60) for j in range(i + 1, 60) if near[i, j]}


MESHES = {
    "trimesh": Stand(vertices=VERTICES, faces=TRIANGLES, vertex_normals=UP, visual=Stand(kind=None)),
    "pyvista": Stand(points=VERTICES, faces=np.array([3, 0, 1, 2, 3, 0, 2, 3]), active_scalars=None),
    "pyvista quad": Stand(points=VERTICES, faces=np.array([4, 0, 1, 2, 3])),
    "pyvista grid": Stand(points=VERTICES, extract_surface=lambda: MESHES["pyvista"]),
    "meshio": Stand(
        points=VERTICES, cells=[Stand(type="line", data=[(0, 1)]), Stand(type="triangle", data=TRIANGLES)]
    ),
    "meshio plane quad": Stand(points=VERTICES[:, :2], cells=[Stand(type="quad", data=np.array([(0, 1, 2, 3)]))]),
}


@pytest.mark.parametrize("name", MESHES)
def test_meshes(name):
    scene = glint.show(MESHES[name], direction="front", size=(40, 40), background="black")
    assert len(scene.shapes) == 2
    corners = {tuple(corner) for shape in scene.shapes for corner in shape.vertices.tolist()}
    assert corners == set(map(tuple, VERTICES.tolist()))
    assert (scene.render().array[10:30, 10:30] > 0.1).all()
    assert scene.shapes[0].kind == ("smooth_triangle" if name == "trimesh" else "triangle")


CELLS = {
    "tetra": ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], 4, 1 / 6),
    "pyramid": ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1)], 6, 1 / 3),
    "wedge": ([(0, 0, 0), (0, 1, 0), (1, 0, 0), (0, 0, 1), (0, 1, 1), (1, 0, 1)], 8, 1 / 2),
    "hexahedron": ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], 12, 1),
}


@pytest.mark.parametrize("kind", CELLS)
def test_cells_with_a_volume_have_their_outside(kind):
    points, count, volume = CELLS[kind]
    found = _accept.mesh_arrays(Stand(points=np.array(points), cells=[Stand(type=kind, data=[range(len(points))])]))
    corners = found.vertices[found.triangles]
    assert len(corners) == count
    assert np.linalg.det(corners).sum() / 6 == pytest.approx(volume)  # counter-clockwise from outside


def test_faces_between_cells_are_left_out():
    points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)])
    cells = [Stand(type="tetra10", data=[(0, 1, 2, 3, *[0] * 6), (1, 2, 3, 4, *[0] * 6)])]
    assert len(_accept.mesh_arrays(Stand(points=points, cells=cells)).triangles) == 6


def test_values_of_faces_and_of_cells():
    """Of faces with more corners than three, and of cells whose outside is drawn; a color of three numbers is one."""
    grey = dict(colormap=lambda x: np.repeat(x[:, None], 3, axis=1))
    strip = np.array([(x, y, 0.0) for x in range(4) for y in range(2)])
    quads = np.array([(0, 2, 3, 1), (2, 4, 5, 3), (4, 6, 7, 5)])
    blocks = Stand(points=strip, cells=[Stand(type="quad", data=quads[:1]), Stand(type="quad", data=quads[1:])])
    ragged = Stand(points=strip, faces=np.array([4, 0, 2, 3, 1, 3, 2, 4, 5, 4, 4, 6, 7, 5]), active_scalars=np.arange(3))
    for mesh, shades in ((blocks, [0, 0, 0.5, 0.5, 1, 1]), (ragged, [0, 0, 0.5, 1, 1])):
        scene = glint.Scene()
        assert len(scene.mesh(mesh, values=[5, 6, 7], **grey)) == len(shades)
        assert [shape.color.r for shape in scene.shapes] == shades
    with pytest.warns(glint.GlintWarning, match="values: 2 of 6"):
        scene.mesh(blocks, values=np.ma.masked_equal([5, 6, 7], 6), **grey)
    scene = glint.Scene()
    scene.mesh(blocks, ["red", "lime", "blue"])
    assert scene.shapes[2].color == (0, 1, 0)
    scene.mesh(blocks, (0.5, 0.25, 1))
    assert scene.shapes[6].material.color == (0.5, 0.25, 1)
    cells = Stand(points=strip, cells=[Stand(type="tetra", data=np.array([(0, 1, 2, 3), (4, 5, 6, 7)]))])
    scene = glint.Scene()
    scene.mesh(cells, values=[1, 2], **grey)
    assert [shape.color.r for shape in scene.shapes] == [0, 1] * 4


@pytest.mark.parametrize("name", ["to_mesh", "dump"])
def test_scenes_of_trimesh(name):
    parts = Stand(geometry={}, dump=lambda concatenate: MESHES["trimesh"])
    if name == "to_mesh":
        parts = Stand(geometry={}, dump=None, to_mesh=lambda: MESHES["trimesh"])
    assert len(glint.show(parts).shapes) == 2


def test_colors_of_vertices_and_of_faces():
    bytes_of_vertices = np.array([(255, 0, 0, 255)] * 3 + [(0, 0, 255, 255)], np.uint8)
    colored = Stand(
        vertices=VERTICES, faces=TRIANGLES, visual=Stand(kind="vertex", vertex_colors=bytes_of_vertices)
    )
    scene = glint.Scene()
    assert scene.add(colored) == range(0, 1)
    assert scene.shapes[0].colors.tolist() == [[1, 0, 0]] * 3 + [[0, 0, 1]]
    colored.visual = Stand(kind="face", face_colors=bytes_of_vertices[2:])
    scene = glint.Scene()
    scene.add(colored)
    assert [shape.color for shape in scene.shapes] == [(1, 0, 0), (0, 0, 1)]
    scene = glint.Scene()
    scene.mesh(MESHES["trimesh"], np.eye(4)[:, :3], smooth=False)
    assert scene.shapes[0].colors.tolist() == np.eye(4)[:, :3].tolist() and scene.shapes[0].normals is None
    scene.mesh(MESHES["trimesh"], ["red", "blue"])
    assert scene.shapes[1].color == (1, 0, 0) and scene.shapes[2].color == (0, 0, 1)
    scene.mesh(MESHES["trimesh"], (1, 0.5, 0))
    assert scene.shapes[3].material.color == (1, 0.5, 0)


def test_values_of_meshes():
    scene = glint.Scene()
    scene.mesh(MESHES["meshio"], values=[0, 1, 2, 4], colormap=lambda x: np.repeat(x[:, None], 3, axis=1))
    assert scene.shapes[0].colors[:, 0].tolist() == [0, 0.25, 0.5, 1]
    scene.mesh(MESHES["meshio"], values=[0, 1], colormap=lambda x: np.repeat(x[:, None], 3, axis=1))
    assert scene.shapes[2].color == (1, 1, 1)
    pytest.importorskip("matplotlib")
    scene.add(Stand(points=VERTICES, faces=np.array([4, 0, 1, 2, 3]), active_scalars=np.arange(4)))
    assert len(np.unique(scene.shapes[3].colors, axis=0)) == 4
    scene.add(Stand(points=VERTICES, faces=np.array([3, 0, 1, 2, 3, 0, 2, 3]), active_scalars=np.arange(2)))
    assert scene.shapes[4].color != scene.shapes[5].color


def test_show_of_scenes_and_shapes(scene):
    shown = glint.show(scene, direction="top", size=(20, 20))
    assert len(shown.lights) == 1 and shown.camera.position[1] > 1 and scene.camera.position == (0, 1, 6)
    assert shown.background == scene.background and glint.show(scene, background="red").background == (1, 0, 0)
    assert len(glint.show(glint.Sphere(), glint.Box((2, 0, 0), (3, 1, 1))).shapes) == 2
    assert len(glint.show(MOLECULES["ase"], glint.Sphere(), bonds=False).shapes) == 4
    with pytest.raises(TypeError, match="add\\(\\) takes no keywords with a Sphere"):
        glint.show(glint.Sphere(), color="red")


@pytest.mark.parametrize(
    "call, error, message",
    [
        (lambda: glint.show(3), TypeError, "glint cannot add 'int' to a scene"),
        (lambda: glint.Scene().mesh(3), TypeError, "mesh: expected an object with vertices and faces, found 3"),
        (lambda: glint.Scene().atoms(3), TypeError, "atoms: expected atoms of ASE, Open Babel or MDAnalysis, or (symbols, positions), found 3"),
        (lambda: glint.show(("OHH", np.zeros((3, 3)))), ValueError, "atoms: all 3 are at (0.0, 0.0, 0.0); Open Babel's make3D()"),
        (lambda: glint.show(("OH", POSITIONS)), ValueError, "atoms: expected a symbol for each position, found 2 and 3"),
        (lambda: glint.show(Stand(atoms=Atoms())), TypeError, "glint cannot add 'SimpleNamespace' to a scene"),
        (lambda: glint.show(), ValueError, "the scene has nothing to fit"),
        (lambda: glint.show(Stand(points=VERTICES, cells=[])), ValueError, "the mesh has no triangles"),
        (lambda: glint.show(MESHES["trimesh"], values=[1, 2, 3]), ValueError, "values: expected one number for each, 2, found 3"),
    ],
)
def test_refuses(call, error, message):
    with pytest.raises(error) as raised:
        call()
    assert str(raised.value).startswith(message)
