# SPDX-License-Identifier: Apache-2.0
"""Sliders of live views."""

import json

import pytest

from live_page import ask, picture


def test_a_slider_changes_the_number(view, scene):
    before = scene.render()
    assert (picture(view, values={"0": 0.25}) != before.to_uint8()).any()
    assert scene.lights["key"].intensity == pytest.approx(0.25)
    picture(view, values={"0": 9})
    assert scene.lights["key"].intensity == pytest.approx(2)
    _, _, content = ask(view, "changes", version=-1)
    (slider,) = json.loads(content)["sliders"]
    assert slider == {"label": "brightness", "value": pytest.approx(2), "lowest": 0, "highest": 2, "step": 0.01}


def test_sliders_of_parts_and_of_settings(scene, opened):
    light = scene.lights["key"]
    red = scene.materials["red"]
    red.diffuse = 0.5
    view = scene.live(
        sliders={"x": (light, "position.x", -5, 5), "limit": (scene.settings, "reflections", 0, 9), "k_d": (red, "diffuse", 0, 1)}
    )
    values = [slider["value"] for slider in json.loads(ask(view, "changes", version=-1)[2])["sliders"]]
    assert values == [4, 4, pytest.approx(0.5)]
    picture(view, values={"0": -3, "1": 2.6, "2": 0.25})
    assert light.position == (-3, 5, 3) and scene.settings["reflections"] == 3
    assert tuple(red.diffuse) == pytest.approx((0.2, 0.025, 0.025))
    view.close()


@pytest.mark.parametrize(
    "slider, error, message",
    [
        ("intensity", TypeError, r"expected \(object, attribute, lowest, highest\), found 'intensity'"),
        (("kind", 0, 1), TypeError, "expected the name of a number, found 'kind'"),
        (("position", 0, 1), TypeError, "found 'position'; of three numbers, 'position.x'"),
        (("radius.x", 0, 1), TypeError, "expected the name of a number, found 'radius.x'"),
        (("intensty", 0, 1), AttributeError, "did you mean 'intensity'"),
        (("intensity", 1, 1), ValueError, "expected a range such as 0, 2, found 1, 1"),
        (("intensity", 0, float("inf")), TypeError, "expected finite numbers as bounds, found inf"),
    ],
)
def test_wrong_sliders_are_refused(scene, opened, slider, error, message):
    with pytest.raises(error, match=message):
        scene.live(sliders={"a": (scene.lights["key"], *slider) if isinstance(slider, tuple) else slider})
    with pytest.raises(TypeError, match="found 'specular'; of three numbers"):
        scene.live(sliders={"a": (scene.materials["red"], "specular", 0, 1)})  # (0.5, 0.5, 0.5) is no factor of red
    with pytest.raises(ValueError, match="there is no 'reflexions' in"):
        scene.live(sliders={"a": (scene.settings, "reflexions", 0, 1)})
    with pytest.raises(TypeError, match="size: expected"):
        scene.live(size=3)
    assert opened == []


def test_values_that_are_no_numbers_any_more(scene, opened):
    scene.settings["aa"] = 2
    view = scene.live(sliders={"aa": (scene.settings, "aa", 1, 4)})
    scene.settings["aa"] = "adaptive:2:0.1"
    assert json.loads(ask(view, "changes", version=-1)[2])["sliders"][0]["value"] == 1
    view.close()
