# SPDX-License-Identifier: Apache-2.0
import pathlib
import webbrowser

import pytest

import glint

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture
def root() -> pathlib.Path:
    return ROOT


@pytest.fixture
def scene() -> glint.Scene:
    """A red ball on a floor, under one light."""
    scene = glint.Scene(size=(64, 48))
    scene.camera.position = (0, 1, 6)
    scene.camera.look_at = (0, 0, 0)
    red = glint.Material(color=(0.8, 0.1, 0.1), specular=(0.5, 0.5, 0.5), name="red")
    scene.add(glint.Sphere((0, 0, 0), 1, material=red, name="ball"))
    scene.add(glint.Plane((0, -1, 0), (0, 1, 0), name="floor"))
    scene.add(glint.Light("point", position=(4, 5, 3), name="key"))
    return scene


@pytest.fixture
def opened(monkeypatch):
    """The addresses that were opened, by a browser that does nothing."""
    addresses = []
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(webbrowser, "open", lambda address: addresses.append(address) or True)
    return addresses


@pytest.fixture
def view(scene, opened):
    """A live view of the scene, with one slider."""
    view = scene.live(sliders={"brightness": (scene.lights["key"], "intensity", 0, 2)})
    yield view
    view.close()
