# SPDX-License-Identifier: Apache-2.0
"""Shapes from arrays, hits as arrays, and objects of other packages."""

import copy
import pickle
import time
import types

import numpy as np
import pytest

import glint


def test_spheres_from_arrays():
    random = np.random.default_rng(1)
    centers, radii = random.random((50, 3)), random.random(50) + 0.1
    colors = random.random((50, 3)).astype(np.float32)
    scene = glint.Scene(size=(40, 30))
    assert scene.spheres(centers, radii, colors) == range(50)
    scene.add(glint.Light("point", position=(5, 5, 5)))
    one_by_one = glint.Scene(size=(40, 30))
    for center, radius, color in zip(centers, radii, colors):
        one_by_one.add(glint.Sphere(center, radius, material=glint.Material(color=color)))
    one_by_one.add(glint.Light("point", position=(5, 5, 5)))
    scene.camera.position = one_by_one.camera.position = (0, 0, 5)
    assert scene.render() == one_by_one.render()
    assert scene.shapes[7].center == tuple(centers[7])
    assert scene.shapes[7].color == tuple(colors[7])


def test_colors_are_those_of_the_shapes():
    scene = glint.Scene()
    colors = np.array([(1, 0, 0), (0, 1, 0)] * 50, float)
    scene.spheres(np.zeros((100, 3)), 1, colors, material=glint.Material(shininess=5))
    assert len(scene.materials) == 1 and scene.materials[0].shininess == 5
    assert scene.shapes[0].color == (1, 0, 0) and scene.shapes[0].material == scene.shapes[1].material
    scene.spheres(np.zeros((10, 3)), 1, (0, 0, 1))
    assert len(scene.materials) == 2
    assert scene.shapes[-1].color is None and scene.shapes[-1].material.color == (0, 0, 1)
    scene.spheres(np.zeros((10, 3)), 1)
    assert scene.shapes[-1].material is None and scene.shapes[-1].color is None
    scene.spheres(np.zeros((2, 3)), 1, [(0, 1, 1, 0.5), (1, 1, 0, 1)])
    assert scene.shapes[-1].color == (1, 1, 0)


def test_the_color_of_a_shape():
    scene = glint.Scene(size=(40, 30))
    scene.add(glint.Light("point", position=(5, 5, 5)))
    scene.camera.position = (0, 0, 4)
    gold = glint.Material(color=(0.75, 0.5, 0.25), specular=0.5)
    ball = scene.add(glint.Sphere((0, 0, 0), 1, material=gold, color=(0.5, 0, 1)))
    assert "color=" in repr(ball) and ball == copy.copy(ball)
    colored = scene.render()
    other = scene.copy()
    assert other == scene and pickle.loads(pickle.dumps(scene)) == scene
    assert pickle.loads(pickle.dumps(scene)).render() == colored
    ball.color = None
    assert other != scene and scene.render() != colored
    ball.material = glint.Material(color=(0.5, 0, 1), specular=0.5)
    assert scene.render() == colored
    ball.material, ball.color = gold, "#8000ff"
    assert ball.color == (np.float32(128 / 255), 0, 1)
    with pytest.raises(ValueError, match="color"):
        ball.color = (np.nan, 0, 0)
    scene.spheres([(2, 0, 0), (3, 0, 0)], 0.2, [(1, 0, 0), (0, 1, 0)])
    del scene.shapes[1]
    assert [shape.color for shape in scene.shapes[1:]] == [(0, 1, 0)]


def test_a_million_spheres():
    random = np.random.default_rng(1)
    centers = random.random((1_000_000, 3))
    colors = random.random((1_000_000, 3))
    scene = glint.Scene()
    start = time.perf_counter()
    scene.spheres(centers, 0.001, colors)
    assert time.perf_counter() - start < 2.5  # half a second where nothing else runs
    assert len(scene.shapes) == 1_000_000


def test_cylinders_and_triangles():
    scene = glint.Scene()
    assert scene.cylinders([(0, 0, 0), (1, 0, 0)], [(0, 1, 0), (1, 1, 0)], [0.1, 0.2]) == range(2)
    assert scene.shapes[1].radius == 0.2 and scene.shapes[1].to == (1, 1, 0)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    faces = [(0, 1, 2), (0, 2, 3)]
    assert scene.triangles(corners, faces, [(1, 0, 0), (0, 1, 0)]) == range(2, 4)
    assert np.array_equal(scene.shapes[3].vertices, [corners[0], corners[2], corners[3]])
    scene.triangles(np.zeros((3, 3, 3)))
    assert scene.shapes[4].kind == "triangle"
    scene.triangles(corners, faces, normals=[(0, 0, 1)] * 4)
    assert scene.shapes[-1].kind == "smooth_triangle"


@pytest.mark.parametrize(
    "arrays, message",
    [
        (dict(centers=np.zeros((5, 2)), radii=1), "centers: expected an array of N x 3 numbers, found 5 x 2"),
        (dict(centers=np.zeros((5, 3)), radii=np.ones(4)), "radii: expected one number or 5, found 4"),
        (dict(centers=np.zeros((5, 3)), radii=[1, 1, 0, 1, 1]), r"radii\[2\]: expected a number > 0"),
        (dict(centers=np.full((5, 3), np.nan), radii=1), r"centers\[0\]: expected"),
        (dict(centers=np.zeros((5, 3)), radii=1, colors=np.zeros((4, 3))), "colors: expected one color or"),
        (dict(centers="x", radii=1), "centers: expected an array"),
    ],
)
def test_refuses_arrays(arrays, message):
    scene = glint.Scene()
    with pytest.raises(ValueError, match=message):
        scene.spheres(**arrays)
    assert len(scene.shapes) == 0


def test_refuses_faces():
    with pytest.raises(IndexError, match=r"faces\[0\]: there is no vertex 7"):
        glint.Scene().triangles(np.zeros((3, 3)), [(0, 1, 7)])


def test_cast(scene):
    hits = scene.cast((0, 0, 5), [(0, 0, -1), (0, 1, 0), (0, -1, 0)])
    assert np.array_equal(hits.shape, [0, -1, 1])
    assert np.allclose(hits.t, [4, np.inf, 1])
    assert np.allclose(hits.normal[0], (0, 0, 1)) and np.allclose(hits.point[2], (0, -1, 5))
    assert list(hits.hit) == [True, False, True] and len(hits) == 3
    depths = scene.cast(np.random.default_rng(1).random((1000, 3)) + (0, 0, 5), (0, 0, -2)).t
    assert depths.shape == (1000,)
    with pytest.raises(ValueError):
        scene.cast(np.zeros((2, 3)), np.ones((3, 3)))


def test_colormaps():
    matplotlib = pytest.importorskip("matplotlib")
    scene = glint.Scene()
    scene.spheres(np.zeros((5, 3)), 1, [0, 1, 2, 3, 4], colormap="viridis")
    wanted = matplotlib.colormaps["viridis"](np.linspace(0, 1, 5))[:, :3]
    assert np.allclose(scene.shapes[2].color, wanted[2])
    scene.spheres(np.zeros((5, 3)), 1, matplotlib.cm.magma(np.linspace(0, 1, 5)))


def test_atoms_of_ase():
    build = pytest.importorskip("ase.build")
    scene = glint.Scene()
    assert scene.add(build.molecule("H2O")) == range(3)
    assert [shape.kind for shape in scene.shapes] == ["sphere"] * 3 + ["cylinder"] * 2
    assert scene.add(build.molecule("H2O"), bonds=False) == range(5, 8)


def test_meshes():
    vertices = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0)]
    mesh = types.SimpleNamespace(vertices=vertices, faces=[(0, 1, 2, 3), (1, 4, 2)])
    scene = glint.Scene()
    assert scene.add(mesh) == range(3)
    quads = types.SimpleNamespace(vertices=vertices, faces=np.array([(0, 1, 2, 3)]), normals=[(0, 0, 1)] * 5)
    scene.add(quads, colors=(1, 0, 0))
    assert scene.shapes[3].kind == "smooth_triangle"
    with pytest.raises(TypeError, match="cannot add 'object'"):
        scene.add(object())


def test_pictures_of_pil(scene):
    pil = pytest.importorskip("PIL.Image")
    image = scene.render()
    assert image.to_pil().size == (64, 48)
    again = glint.Image(image.to_pil())
    assert glint.compare(again, image).identical
    grey = glint.Image(np.full((4, 5), 0.5))
    assert grey.size == (5, 4) and grey.array[0, 0, 2] == 0.5
    assert glint.Image(pil.new("L", (3, 2), 255)).array.max() == 1
    with pytest.raises(ValueError, match="height x width x 3"):
        glint.Image(np.zeros(5))
