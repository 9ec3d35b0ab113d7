# SPDX-License-Identifier: Apache-2.0
"""Attributes of many shapes as arrays: pictures have the bytes of a new scene with these values."""

import copy
import pickle
import resource

import numpy as np
import pytest

import glint

RANDOM = np.random.default_rng(7)


def lit():
    scene = glint.Scene(size=(48, 36))
    scene.add(glint.Light("point", position=(5, 9, 7)))
    scene.camera.position = (0, 0, 6)
    return scene


def pixels(scene):
    return scene.render().array.tobytes()


def new(scene):
    """An equal scene that has not been rendered."""
    return pickle.loads(pickle.dumps(scene))


def places(count, spread=1.5):
    return RANDOM.uniform(-spread, spread, (count, 3))


def turns(count):
    """Matrices that turn, stretch and move."""
    turned = np.linalg.qr(RANDOM.normal(size=(count, 3, 3)))[0] * RANDOM.uniform(0.5, 1.5, (count, 1, 3))
    return np.concatenate([turned, places(count)[:, :, np.newaxis]], axis=2)


@pytest.fixture
def mixed():
    """Spheres 0 to 39, cylinders to 59, triangles to 79, smooth ones to 99; a floor, a disc and a cone."""
    scene = lit()
    scene.spheres(places(40), 0.2, RANDOM.random((40, 3)))
    scene.cylinders(places(20), places(20), 0.05)
    corners = places(20)[:, np.newaxis] + RANDOM.uniform(-0.3, 0.3, (20, 3, 3))
    scene.triangles(corners)
    scene.triangles(corners + 0.2, normals=RANDOM.normal(size=(20, 3, 3)))
    scene.add(glint.Plane((0, -2, 0), (0, 1, 0), name="floor"))
    scene.add(glint.Disc((0, 1, 0), (0, 1, 1), 0.5))
    scene.add(glint.Cone((0, 0, 0), (0, 1, 0), 0.4))
    scene.render()
    return scene


def one_by_one(scene, numbers, name, values):
    """A new scene, in which each shape was set by itself."""
    other = scene.copy()
    for number, value in zip(numbers, values):
        setattr(other.shapes[int(number)], name, value)
    return new(other)


@pytest.mark.parametrize(
    "key, attribute, name, values",
    [
        (range(40), "centers", "center", places(40)),
        ([3, 101, 7], "centers", "center", places(3)),
        (slice(10, 60), "radii", "radius", RANDOM.uniform(0.05, 0.4, 50)),
        (slice(40, 60), "from_", "from_", places(20)),
        ([41, 45, 102], "to", "to", places(3)),
        (slice(60, 100), "vertices", "vertices", places(120).reshape(40, 3, 3)),
        (slice(80, 100), "normals", "normals", RANDOM.normal(size=(20, 3, 3))),
        (slice(None), "colors", "color", RANDOM.random((103, 3))),
        (slice(90, 103), "transforms", "transform", turns(13)),
        (np.arange(103) % 5 == 0, "transforms", "transform", turns(21)),
    ],
)
def test_pictures_are_those_of_a_new_scene(mixed, key, attribute, name, values):
    selection = mixed.shapes[key]
    numbers = np.arange(103)[list(key) if isinstance(key, range) else key]
    wanted = one_by_one(mixed, numbers, name, values)
    before = pixels(mixed)
    setattr(selection, attribute, values)
    found = getattr(selection, attribute)
    assert found.dtype == np.float64 and found.shape == values.shape
    assert np.array_equal(found, values.astype(np.float32) if attribute == "colors" else values)
    assert pixels(mixed) == pixels(wanted) != before
    getattr(selection, attribute)[...] = 7  # an array of its own
    assert pixels(mixed) == pixels(wanted)


def test_all_shapes_by_one_name():
    scene = lit()
    scene.spheres(places(50), 0.2)
    scene.add(glint.Disc((0, 0, 0), (0, 0, 1), 0.3))
    scene.render()
    scene.shapes.centers += (0.5, 0, 0)
    scene.shapes.radii = 0.3
    assert scene.shapes[50].center.x == 0.5 and scene.shapes[7].radius == 0.3
    again = lit()
    again.spheres(scene.shapes[:50].centers, 0.3)
    again.add(glint.Disc((0.5, 0, 0), (0, 0, 1), 0.3))
    assert pixels(scene) == pixels(again)


def test_objects_see_arrays_and_arrays_see_objects(mixed):
    ball, plane = mixed.shapes[3], mixed.shapes["floor"]
    ball.radius = 0.7  # before the array, without a picture in between
    mixed.shapes[:40].centers = np.zeros((40, 3))
    assert ball.center == (0, 0, 0) and ball.radius == 0.7
    mixed.shapes.colors = "orange"
    assert ball.color == plane.color == mixed.shapes[102].color
    gold = glint.Material(color="gold", mirror=0.2)
    mixed.shapes[:4].materials = gold
    assert ball.material is gold and mixed.shapes[:5].materials == [gold] * 4 + [None]
    turn = turns(1)[0]
    mixed.shapes[3:4].transforms = turn
    assert np.array_equal(ball.transform, turn)
    mixed.shapes[:40].transforms = None
    assert ball.transform is None
    ball.center = (1, 2, 3)
    assert np.array_equal(mixed.shapes[2:5].centers, [(0, 0, 0), (1, 2, 3), (0, 0, 0)])
    mixed.shapes[[3]].colors = None
    assert ball.color is None and np.isnan(mixed.shapes[3:4].colors).all() and plane.color is not None
    gold.color = (0, 0, 1)
    assert pixels(mixed) == pixels(mixed.copy())
    assert pixels(mixed) == pixels(new(mixed))


def test_materials(mixed):
    red, blue = glint.Material(color=(1, 0, 0)), glint.Material(color=(0, 0, 1))
    mixed.shapes[:40].materials = [red, blue, None, red] * 10
    for i in range(40):
        assert mixed.shapes[i].material == (red, blue, None, red)[i % 4]
    assert len(mixed.materials) == 2
    wanted = mixed.copy()
    assert pixels(mixed) == pixels(new(wanted))


def test_films_reuse_transforms():
    scene = lit()
    scene.spheres(places(50_000), 0.2)
    maps = turns(50_000)
    scene.shapes.transforms = maps
    scene.shapes.transforms = maps
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(40):  # 5 MB each, if they were kept
        scene.shapes.transforms = maps
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 100_000
    assert np.array_equal(scene.shapes.transforms, maps)


def test_a_copy_keeps_its_values():
    scene = lit()
    scene.spheres(places(50), 0.2)
    other = scene.copy()
    old = pixels(scene)
    scene.shapes.centers = places(50)
    assert pixels(other) == old != pixels(scene)


def test_many_edits_without_a_picture():
    scene = lit()
    scene.spheres(places(20), 0.2)
    scene.render()
    for i in range(3000):
        scene.shapes[[i % 20, (i * 7 + 3) % 20]].radii = 0.1 + i % 3 / 10
    again = lit()
    again.spheres(scene.shapes.centers, scene.shapes.radii)
    assert pixels(scene) == pixels(again)


def test_selections():
    scene = lit()
    scene.spheres(places(10), 0.2)
    some = scene.shapes[2:8:2]
    assert len(some) == 3 and some[1] is scene.shapes[4] and some[-1].center == scene.shapes[6].center
    assert some == [scene.shapes[i] for i in (2, 4, 6)] and some == scene.shapes[[2, 4, -4]]
    assert some + [1] == [*some, 1] and scene.shapes[4] in some and pickle.loads(pickle.dumps(some)) == some
    assert repr(some).startswith("[Sphere(center=") and some[1:].radii.shape == (2,)
    assert len(scene.shapes[[]]) == 0 and scene.shapes[range(0)].centers.shape == (0, 3)
    scene.shapes[np.zeros(10, bool)].centers = np.zeros((0, 3))
    kept = list(some)
    del scene.shapes[scene.shapes.centers[:, 0] < np.median(scene.shapes.centers[:, 0])]
    assert len(scene.shapes) == 5 and len(kept) == 3
    with pytest.raises(RuntimeError, match="shapes were removed.*select again"):
        some.centers


ZEROS = np.zeros((40, 3))


@pytest.mark.parametrize(
    "key, attribute, value, kind, message",
    [
        (slice(None), "centers", None, TypeError, "centers: expected spheres, discs and tori, found the shape 40, which is of the kind cylinder"),
        ([100], "centers", ZEROS[:1], TypeError, "found the shape 100, which is of the kind plane and has the name 'floor'; choose spheres"),
        (slice(40), "centers", ZEROS[:39], ValueError, "centers: expected an array of 40 x 3, found 39 x 3"),
        (slice(40), "centers", (0, 0, 0), ValueError, "centers: expected an array of 40 x 3, found 3"),
        (slice(40), "centers", np.where(np.arange(120) == 10, np.nan, 0).reshape(40, 3), ValueError, r"centers\[3\]: expected a number from"),
        (slice(40), "radii", [0.1] * 39 + [-1], ValueError, r"radii\[39\]: expected a number > 0 and at most 1e12, found -1"),
        (slice(40), "radii", [0.1] * 5, ValueError, "radii: expected one number or 40, found 5"),
        (slice(40), "radii", "big", ValueError, "radii: expected an array of numbers"),
        (slice(60, 80), "vertices", np.zeros((20, 3)), ValueError, "vertices: expected an array of 20 x 3 x 3, found 20 x 3"),
        (slice(40), "colors", [(1, 0, 0)] * 3, ValueError, "colors: expected one color or an array of 40 x 3 numbers, found 3 x 3"),
        (slice(40), "colors", ZEROS + np.nan, ValueError, r"colors\[0\]: expected a number from"),
        (slice(40), "colors", ["red"] * 39 + ["redd"], ValueError, r"colors\[39\]"),
        (slice(2), "transforms", np.zeros((2, 3, 4)), ValueError, r"transforms\[0\] flattens what it transforms: it has no inverse"),
        (slice(2), "transforms", [np.eye(4), np.ones((4, 4))], ValueError, r"transforms\[1\]: expected a last row of 0, 0, 0, 1"),
        (slice(2), "transforms", np.zeros((3, 3, 4)), ValueError, "transforms: expected an array of 2 x 3 x 4 or"),
        (slice(3), "materials", [None] * 2, ValueError, "materials: expected one Material or 3, found 2"),
        (slice(2), "materials", [None, "red"], TypeError, r"materials\[1\]: expected a Material or None, found 'red'"),
        (slice(2), "materials", 3, TypeError, "materials: expected a Material, None or one for each"),
        (slice(2), "centres", 3, AttributeError, "ShapeSelection has no attribute 'centres'; did you mean 'centers'"),
    ],
)
def test_refuses(mixed, key, attribute, value, kind, message):
    before, picture = copy.copy(mixed), pixels(mixed)
    with pytest.raises(kind, match=message):
        if value is None:
            getattr(mixed.shapes[key], attribute)
        else:
            setattr(mixed.shapes[key], attribute, value)
    assert mixed == before and pixels(mixed) == picture


@pytest.mark.parametrize(
    "key, kind, message",
    [
        ([0, 103], IndexError, "there is no shape 103: the scene has 103"),
        ([-104], IndexError, "there is no shape -104"),
        (np.ones(5, bool), IndexError, "the mask has 5 values, the scene has 103 shapes"),
        (1.5, TypeError, "shapes: expected a number, a name, a slice, a range"),
        ([[1, 2]], TypeError, "shapes: expected a number"),
        ([0.5], TypeError, "shapes: expected a number"),
        (None, TypeError, "shapes: expected a number"),
    ],
)
def test_refuses_numbers(mixed, key, kind, message):
    with pytest.raises(kind, match=message):
        mixed.shapes[key]
    with pytest.raises(AttributeError, match="did you mean 'centers'"):
        mixed.shapes.centres = 1
