# SPDX-License-Identifier: Apache-2.0
import pathlib

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
