# SPDX-License-Identifier: Apache-2.0
"""Messages about what other programs call otherwise, and about calls with wrong arguments."""

import re
from types import SimpleNamespace as Stand

import numpy as np
import pytest

import glint
from glint import _hints

POINTS = np.zeros((4, 3))
BOX = glint.Box()


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda s: s.render(spp=16), "render() has no keyword 'spp'; glint has aa=4, which is 4 x 4 samples a pixel"),
        (lambda s: s.render(sice=(4, 4)), "render() has no keyword 'sice'; did you mean 'size'?"),
        (lambda s: s.render("a.png"), "render() takes keywords only, such as size=; found 'a.png' without a keyword"),
        (lambda s: s.add_mesh(Stand()), "add_mesh(): missing a required argument: 'faces'; glint has mesh()"),
        (lambda s: s.spheres(POINTS, c="red"), "spheres() has no keyword 'c'; glint has colors or values"),
        (lambda s: s.spheres(POINTS, 1, "red", "blue"), "spheres() takes centers, radii, colors and then keywords; found 'blue'"),
        (lambda s: s.add(POINTS), "glint cannot add 'ndarray' to a scene; spheres(centers, radii) adds points"),
        (lambda s: s.add([BOX]), "glint cannot add 'list' to a scene; add them one by one"),
        (lambda s: s.add(BOX, color="red"), "add() takes no keywords with a Box, which has attributes; found color"),
        (lambda s: glint.Material(roughness=0.1), "Material has no attribute 'roughness'; glint has shininess"),
        (lambda s: glint.Camera(origin=(0, 0, 1)), "Camera has no attribute 'origin'; glint has position"),
        (lambda s: glint.animate([], "a.gif", duration=1), "animate() has no keyword 'duration'; glint has fps"),
        (lambda s: glint.explain(s, (3, 3)), "explain(): missing a required argument: 'y'"),
    ],
)
def test_wrong_calls(scene, call, message):
    with pytest.raises(TypeError) as raised:
        call(scene)
    assert str(raised.value).startswith(message)


def test_attributes_of_other_programs(scene):
    class Mine(glint.Scene):
        pass

    for one in (scene, glint.Scene()):
        with pytest.raises(AttributeError, match=re.escape("has no attribute 'explain'; glint has glint.explain(scene, x, y)")):
            one.explain(3, 3)
    with pytest.raises(AttributeError, match=r"Camera has no attribute 'focal_point'; glint has look_at"):
        scene.camera.focal_point = (0, 0, 0)
    with pytest.raises(AttributeError, match=r"Mine has no attribute 'export'; glint has"):
        Mine().export("a.glb")


@pytest.mark.parametrize("kind", _hints._ATTRIBUTES)
def test_the_hints_are_about_names_that_glint_has(kind):
    for name, hint in _hints._ATTRIBUTES[kind].items():
        assert not hasattr(getattr(glint, kind), name)
        owner, _, attribute = re.match(r"([a-z]+)(?:\.(\w+))?", re.sub("^del ", "", hint)).group(0).partition(".")
        owners = {"scene": glint.Scene, "image": glint.Image, "glint": glint}
        assert hasattr(owners[owner], attribute) if attribute else hasattr(getattr(glint, kind), re.match(r"\w+", hint).group(0))


def test_colors_and_maps_of_matplotlib():
    pytest.importorskip("matplotlib")
    scene = glint.Scene()
    scene.spheres(POINTS, 1, ["tab:blue", "tab:red", "red", "tab:grey"])
    assert scene.shapes[0].color == pytest.approx((0x1F / 255, 0x77 / 255, 0xB4 / 255))
    with pytest.raises(ValueError, match="no colormap 'virids'; did you mean 'viridis'"):
        glint.ColorScale([1, 2], "virids")
    with pytest.raises(KeyError, match="there is no setting 'sizes'; did you mean 'size'"):
        scene.settings["sizes"]
