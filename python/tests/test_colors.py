# SPDX-License-Identifier: Apache-2.0
"""Colors of data, of names and of bytes."""

import numpy as np
import pytest

import glint

VALUES = [1.0, 2.0, 3.0]
CENTERS = [(0, 0, 0), (1, 0, 0), (2, 0, 0)]
VERTICES = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]


def grey(x):
    """A colormap without matplotlib."""
    return np.repeat(np.asarray(x)[..., np.newaxis], 3, axis=-1)


def colors_of(scene):
    return [shape.color for shape in scene.shapes]


def test_values_have_the_colors_of_a_scale():
    scene = glint.Scene()
    scene.spheres(CENTERS, 0.1, values=VALUES, colormap=grey)
    assert colors_of(scene) == [(0, 0, 0), (0.5, 0.5, 0.5), (1, 1, 1)]
    scene = glint.Scene()
    scene.cylinders(CENTERS, [(x, 1, 0) for x in range(3)], 0.1, values=VALUES, colormap=grey, vmin=0, vmax=2)
    assert colors_of(scene) == [(0.5, 0.5, 0.5), (1, 1, 1), (1, 1, 1)]
    scene = glint.Scene()
    scene.triangles(VERTICES, [(0, 1, 2)], values=[3], colormap=grey, vmin=2, vmax=4)
    assert colors_of(scene) == [(0.5, 0.5, 0.5)]
    mesh = scene.add_mesh(VERTICES, [(0, 1, 2)], values=VALUES, colormap=grey)
    assert mesh.colors.tolist() == [[0] * 3, [0.5] * 3, [1] * 3]


def test_nan_has_a_color_of_its_own_and_infinity_does_not_count():
    scene = glint.Scene()
    centers = [(i, 0, 0) for i in range(6)]
    with pytest.warns(glint.GlintWarning, match="1 of 6 have no color of the scale") as warned:
        scene.spheres(centers, 0.1, values=[1, np.nan, 3, np.inf, -np.inf, 2], colormap=grey, nan_color="red")
    assert warned[0].message.diagnostic.severity == "warning" and warned[0].filename == __file__
    assert colors_of(scene) == [(0,) * 3, (1, 0, 0), (1,) * 3, (1,) * 3, (0,) * 3, (0.5,) * 3]
    masked = np.ma.masked_greater([1.0, 2.0, 9.0], 5)
    assert glint.ColorScale(masked, grey)(masked).tolist() == [[0] * 3, [1] * 3, [0.5] * 3]


def test_all_values_equal_or_missing():
    assert glint.ColorScale([2, 2], grey)([2, 2]).tolist() == [[0] * 3] * 2
    assert glint.ColorScale([np.nan], grey, nan_color=(0, 0, 1))([np.nan]).tolist() == [[0, 0, 1]]
    assert glint.ColorScale([], grey)([]).shape == (0, 3)


def test_norms():
    scale = glint.ColorScale([1, 10, 100], grey, norm="log")
    assert scale([1, 10, 100]) == pytest.approx(grey([0, 0.5, 1]))
    assert scale([0, -1]).tolist() == [[0.5] * 3] * 2  # nan_color
    colors = pytest.importorskip("matplotlib.colors")
    norm = colors.CenteredNorm(0)
    assert glint.ColorScale([-1, 4], grey, norm=norm)([-4, 0, 4, np.nan]).tolist() == grey([0, 0.5, 1, 0.5]).tolist()
    assert norm.halfrange is None  # it is copied
    assert glint.ColorScale([], "viridis", norm=colors.LogNorm(1, 100))([10]) == pytest.approx(
        glint.ColorScale([0, 1])([0.5]), abs=0.01
    )


@pytest.mark.parametrize(
    "options, message",
    [
        (dict(values=[1, 2]), "values: expected one number for each, 3, found 2"),
        (dict(values=["a", "b", "c"]), "values: expected one number for each, found"),
        (dict(values=VALUES, colors="red"), "expected colors or values, found both"),
        (dict(values=VALUES, norm="cube"), "norm: expected 'linear', 'log' or a norm of matplotlib, found 'cube'"),
        (dict(values=VALUES, vmin=3, vmax=2), "vmin and vmax: expected vmin <= vmax, found 3.0 and 2.0"),
        (dict(values=VALUES, vmin=-1, norm="log"), "vmin: expected a number > 0 with norm='log', found -1.0"),
        (dict(values=VALUES, colormap=3), "colormap: expected a name or a colormap of matplotlib, found 3"),
        (dict(values=VALUES, colormap="jett"), "colormap: matplotlib has no colormap 'jett'"),
        (dict(values=VALUES, nan_color="rde"), "nan_color: expected a color such as 'red' or '#ff0000', found 'rde'"),
        (dict(vmin=1), "vmin, vmax and norm are for values="),
        (dict(colors=["red", "rde", "blue"]), "colors[1]: expected a color such as 'red' or '#ff0000', found 'rde'"),
    ],
)
def test_refuses(options, message):
    with pytest.raises((TypeError, ValueError)) as raised:
        glint.Scene().spheres(CENTERS, 0.1, **options)
    assert str(raised.value).startswith(message)


def test_a_bar_shows_the_scale():
    scale = glint.ColorScale([0, 1], grey)
    bar = scale.bar((4, 2))
    assert bar.size == (4, 2) and bar.array[1, :, 0].tolist() == [0.125, 0.375, 0.625, 0.875]
    assert scale.bar((2, 4)).array[:, 0, 0].tolist() == [0.875, 0.625, 0.375, 0.125]


def test_a_bar_for_matplotlib():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    scale = glint.ColorScale([1, 5], "plasma", vmax=9)
    figure, axes = pyplot.subplots()
    bar = figure.colorbar(scale.mappable(), ax=axes, label="B-factor")
    assert (bar.vmin, bar.vmax) == (1, 9)
    assert scale.mappable().to_rgba([3])[0, :3] == pytest.approx(scale([3])[0])
    pyplot.close(figure)


def test_names_and_hexadecimal_digits():
    light = glint.Light(color="red")
    assert light.color == (1, 0, 0)
    for text, color in (("#f80", (1, 0x88 / 255, 0)), ("#FF8000", (1, 128 / 255, 0)), ("#ff800080", (1, 128 / 255, 0))):
        light.color = text
        assert light.color == color
    assert glint.Scene(background="Dark Blue").background == (0, 0, 0x8B / 255)
    scene = glint.Scene()
    scene.spheres(CENTERS, 0.1, ["red", "#0f0", "blue"])
    assert colors_of(scene) == [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    with pytest.raises(ValueError, match="or a name, such as 'red', found 'rde'"):
        light.color = "rde"


def test_bytes_are_from_0_to_255():
    white = np.array([255, 255, 0], np.uint8)
    assert glint.Light(color=white).color == (1, 1, 0)
    assert glint.Material(color=np.uint8(51)).color == (0.2, 0.2, 0.2)
    assert glint.Light(color=np.array([255, 0, 255, 128], np.uint8)).color == (1, 0, 1)
    scene = glint.Scene(background=white)
    assert scene.background == (1, 1, 0)
    scene.spheres(CENTERS, 0.1, np.tile(white, (3, 1)))
    scene.cylinders(CENTERS, [(x, 1, 0) for x in range(3)], 0.1, white)
    assert scene.shapes[2].color == (1, 1, 0) and scene.shapes[3].material.color == (1, 1, 0)
    assert scene.add_mesh(VERTICES, [(0, 1, 2)], colors=np.tile(white, (3, 1))).colors.tolist() == [[1, 1, 0]] * 3
    assert glint.Mesh(VERTICES, [(0, 1, 2)], None, np.tile(white, (3, 1))).colors.max() == 1
