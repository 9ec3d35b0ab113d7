# SPDX-License-Identifier: Apache-2.0
"""Meshes of grids of points."""

import numpy as np
import pytest

import glint

X, Y = np.linspace(0, 3, 4), np.linspace(0, 2, 3)[:, None]


def test_a_plane_is_seen_from_above():
    plane = glint.surface(X, Y, 0.5)
    assert plane.vertices.tolist() == [[x, y, 0.5] for y in range(3) for x in range(4)]
    assert plane.faces[:2].tolist() == [[0, 1, 5], [0, 5, 4]] and len(plane.faces) == 12
    assert plane.vertex_normals.tolist() == [[0, 0, 1]] * 12


def test_normals_of_a_sphere_are_its_radii():
    """Within half a degree, also at the poles and at the seam, whose points are doubled."""
    theta, phi = np.linspace(0, np.pi, 61)[:, None], np.linspace(0, 2 * np.pi, 121)
    sphere = glint.surface(np.sin(theta) * np.sin(phi), np.sin(theta) * np.cos(phi), np.cos(theta) + 0 * phi)
    np.testing.assert_allclose(sphere.vertex_normals, sphere.vertices, atol=0.008)
    grid = sphere.vertex_normals.reshape(61, 121, 3)
    assert (grid[:, 0] == grid[:, -1]).all() and np.allclose(grid[0], (0, 0, 1))


def test_values_are_of_the_grid():
    """Also where there are as many triangles as points."""
    grey = dict(colormap=lambda x: np.repeat(x[:, None], 3, axis=1))
    heights = X + 10 * Y
    for values in (heights, heights.ravel()):
        scene = glint.Scene()
        assert scene.add(glint.surface(X, Y, heights), values=values, **grey) == range(0, 1)
        mesh = scene.shapes[0]
        assert mesh.colors[:, 0] == pytest.approx(heights.ravel() / heights.max()) and mesh.normals is not None
    scene.add(glint.surface(X, Y, heights), colors=np.zeros((3, 4, 3)))
    assert (scene.shapes[1].colors == 0).all()


def test_show_has_an_upright_direction():
    scene = glint.show(glint.surface(X, Y, 0), direction=(1, -1, 1), up=(0, 0, 1), size=(40, 30))
    assert scene.camera.up == (0, 0, 1) and scene.camera.position.z > 1


@pytest.mark.parametrize(
    "axes, message",
    [
        ((X, X, X), "x, y, z: expected grids of at least 2 x 2 numbers, found 4"),
        ((0, 0, 0), "x, y, z: expected grids of at least 2 x 2 numbers, found one number"),
        ((X, Y, np.zeros((2, 2))), "x, y, z: expected grids of one size, found 4, 3 x 1, 2 x 2"),
        ((X, Y, "high"), "x, y, z: expected grids of one size, found 4, 3 x 1, 'high'"),
        ((X, Y, np.where(X == 2, np.nan, Y)), "z: row 0, column 2: expected a number, found nan"),
    ],
)
def test_refuses(axes, message):
    with pytest.raises(ValueError) as raised:
        glint.surface(*axes)
    assert str(raised.value) == message
