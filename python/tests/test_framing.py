# SPDX-License-Identifier: Apache-2.0
"""Cameras that find what there is to see."""

import numpy as np
import pytest

import glint

pytestmark = pytest.mark.filterwarnings("ignore::glint.GlintWarning")


@pytest.fixture
def molecule():
    scene = glint.Scene(glint.Light("ambient"), size=(80, 60), background=(0, 0, 1))
    scene.spheres(np.random.default_rng(1).normal(size=(50, 3)) * (4, 1, 2) + (10, 20, -30), 0.3, "white")
    return scene


def free_sides(image):
    """How many pixels without shapes there are at the left, the right, the top and the bottom."""
    seen = image.array[:, :, 0] > 0
    columns, rows = np.flatnonzero(seen.any(axis=0)), np.flatnonzero(seen.any(axis=1))
    return columns[0], image.width - 1 - columns[-1], rows[0], image.height - 1 - rows[-1]


def test_bounds():
    scene = glint.Scene(glint.Plane((0, -9, 0), (0, 1, 0)))
    assert scene.bounds is None
    scene.add(glint.Sphere((1, 2, 3), 0.5))
    scene.add(glint.Box((0, 0, 0), (1, 1, 1), transform=[[1, 0, 0, -5], [0, 1, 0, 0], [0, 0, 1, 0]]))
    low, high = scene.bounds
    assert low == pytest.approx((-5, 0, 0), abs=1e-5) and high == pytest.approx((1.5, 2.5, 3.5), abs=1e-5)
    assert isinstance(low, glint.Vec3)


@pytest.mark.filterwarnings("error::glint.GlintWarning")
def test_bounds_leave_warnings_to_the_picture():
    scene = glint.Scene(glint.Sphere())
    assert scene.bounds is not None
    with pytest.warns(glint.GlintWarning, match="no lights"):
        scene.render(size=(4, 4))


def test_a_camera_that_was_not_set_frames_the_scene(molecule):
    sides = free_sides(molecule.render())
    assert min(sides) >= 3 and max(min(sides[:2]), min(sides[2:])) < 20
    molecule.add(glint.Sphere((10, 60, -30), 1))  # added later: it is seen, too
    assert min(free_sides(molecule.render())) >= 2
    tall = molecule.render(size=(30, 90))
    assert min(free_sides(tall)) >= 1
    assert glint.explain(molecule, 40, 30, size=(80, 60)).data


def test_a_camera_that_was_set_stays(molecule):
    molecule.camera.position = (0, 0, 5)
    molecule.render()
    assert molecule.camera.position == (0, 0, 5) and molecule.camera.look_at == (0, 0, -1)
    other = glint.Scene(glint.Sphere(), camera=glint.Camera(), size=(8, 8))
    other.render()
    assert other.camera == glint.Camera()
    read = glint.loads("camera { position = (0, 2, 8) look_at = (0, 1, 0) fov_x = 50 } sphere { center = (0, 0, 0) radius = 1 }")
    camera = read.camera.__copy__()
    read.render(size=(8, 8))
    assert read.camera == camera
    # After a picture, too.
    third = glint.Scene(glint.Sphere(), size=(8, 8))
    third.render()
    third.camera.orbit(30)
    turned = third.camera.position
    third.render()
    assert third.camera.position == turned


@pytest.mark.parametrize("direction", ["iso", "front", "back", "left", "right", "top", "bottom", "-x", (1, -0.5, 2)])
@pytest.mark.parametrize("projection", ["perspective", "orthographic"])
@pytest.mark.parametrize("fov_axis", ["x", "y"])
def test_fit(molecule, direction, projection, fov_axis):
    molecule.camera.projection = projection
    molecule.camera.fov_axis = fov_axis
    assert molecule.camera.fit(molecule, direction, margin=0.1) is molecule.camera
    sides = free_sides(molecule.render())
    assert sides[0] >= 7 and sides[1] >= 7 and sides[2] >= 5 and sides[3] >= 5
    assert min(sides[:2]) < 24 or min(sides[2:]) < 18


def test_fit_of_a_part_and_of_axes():
    camera = glint.Camera().fit([(0, 0, 0), (2, 2, 2)], "top")
    assert camera.look_at == (1, 1, 1) and camera.position[1] > 2 and camera.up == (0, 0, -1)
    assert glint.Camera().fit([(0, 0, 0), (2, 2, 2)], "front", up=(1, 0, 0)).up == (1, 0, 0)
    assert glint.Camera().fit([(1, 1, 1), (1, 1, 1)]).look_at == (1, 1, 1)  # one point


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda c: c.fit(glint.Scene()), "the scene has nothing to fit"),
        (lambda c: c.fit(3), "expected a scene or its bounds (min, max), two points, found 3"),
        (lambda c: c.fit([(0, 0, 0), (1, 1, 1)], "frnt"), "direction: expected one of iso, front"),
        (lambda c: c.fit([(0, 0, 0), (1, 1, 1)], (0, 0, 0)), "direction: expected three numbers, not all 0"),
        (lambda c: c.fit([(0, 0, 0), (1, 1, 1)], margin=0.5), "margin: expected a number from 0 to less than 0.5"),
        (lambda c: c.fit([(0, 0, 0), (1, 1, 1)], margin="a"), "margin: expected a number, found 'a'"),
        (lambda c: c.orbit("a"), "right: expected a number, found 'a'"),
        (lambda c: c.zoom("a"), "factor: expected a number, found 'a'"),
        (lambda c: c.zoom(0), "factor: expected a number > 0, found 0"),
    ],
)
def test_refuses(call, message):
    with pytest.raises((TypeError, ValueError)) as raised:
        call(glint.Camera())
    assert str(raised.value).startswith(message)


@pytest.mark.parametrize("projection", ["perspective", "orthographic"])
def test_zoom(projection):
    """The middle part of a picture, twice as large."""
    scene = glint.Scene(glint.Box((-1, -1, -1), (1, 1, 1)), glint.Light("ambient"), size=(80, 80))
    scene.camera = glint.Camera(position=(0, 0, 9), look_at=(0, 0, 0), fov=50, projection=projection, width=8)
    middle = scene.render(crop="40x40+20+20").to_uint8()
    assert scene.camera.zoom(2) is scene.camera and scene.camera.position == (0, 0, 9)
    assert (scene.render(size=(40, 40)).to_uint8() == middle).all() and middle.any() and not middle.all()


def test_orbit():
    camera = glint.Camera(position=(0, 0, 5), look_at=(0, 0, 0))
    camera.orbit(90)
    assert camera.position == pytest.approx((5, 0, 0))
    camera.orbit(up=30)
    assert camera.position == pytest.approx((5 * np.cos(np.pi / 6), 2.5, 0))
    camera.orbit(up=180)
    assert 4.99 < camera.position[1] < 5 and camera.position[0] > 0


def test_turntable(molecule):
    molecule.camera.fit(molecule, "front")
    before = molecule.camera.position
    pictures = list(molecule.turntable(4, size=(20, 15)))
    assert len(pictures) == 4 and len({p.to_bytes() for p in pictures}) == 4
    assert pictures[0] == molecule.render(size=(20, 15)) and molecule.camera.position == before
