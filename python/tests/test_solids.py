# SPDX-License-Identifier: Apache-2.0
"""Solids: shapes that are combined by their insides."""

import copy
import pickle

import numpy as np
import pytest

import glint

RED = glint.Material(color=(1, 0, 0))
MOVED = [(1, 0, 0, 0.25), (0, 1, 0, 0), (0, 0, 1, 0)]
HEAD = "camera { position = (2, 3, 5) look_at = (0, 0, 0) } light point { position = (4, 5, 6) } render { size = 64x48 }\n"
TEXT = """difference {
    color = (0, 1, 0)  translate = (0.1, 0, 0)
    sphere { center = (0, 0, 0) radius = 1 color = (1, 0, 0) }
    intersection {
        translate = (0.25, 0, 0)
        box { min = (0, 0, 0) max = (2, 2, 2) }
        cylinder { from = (0, -2, 0) to = (0, 2, 0) radius = 0.5 translate = (0.5, 0, 0.5) }
    }
}
"""


def same_picture(a, b):
    return np.array_equal(a.render().array, b.render().array)


def scene_with(*shapes):
    scene = glint.Scene(glint.Light("point", position=(4, 5, 6)), size=(64, 48))
    scene.camera.position, scene.camera.look_at = (2, 3, 5), (0, 0, 0)
    for shape in shapes:
        scene.add(shape)
    return scene


def carved():
    """The solid of TEXT."""
    rod = glint.Cylinder((0, -2, 0), (0, 2, 0), 0.5, transform=[(1, 0, 0, 0.5), (0, 1, 0, 0), (0, 0, 1, 0.5)])
    corner = glint.Box((0, 0, 0), (2, 2, 2)) & rod
    corner.transform = MOVED
    solid = glint.Sphere((0, 0, 0), 1, material=RED) - corner
    solid.material = glint.Material(color=(0, 1, 0))
    solid.transform = [(1, 0, 0, 0.1), (0, 1, 0, 0), (0, 0, 1, 0)]
    return solid


def test_a_picture_has_the_bits_of_the_text_s():
    loaded, made = glint.loads(HEAD + TEXT), scene_with(carved())
    assert same_picture(loaded, made) and made.render().array.any()
    assert not same_picture(made, scene_with(glint.Sphere((0.1, 0, 0), 1, material=RED)))
    assert loaded.shapes[0] == made.shapes[0] == carved()
    assert glint.loads(made.to_glint()).to_glint() == made.to_glint()


def test_loaded_solids_have_parts():
    solid = glint.loads(HEAD + TEXT).shapes[0]
    assert type(solid) is glint.Solid and (solid.kind, solid.operation) == ("solid", "difference")
    ball, corner = solid.parts
    assert (ball.kind, ball.material) == ("sphere", RED)
    assert corner.operation == "intersection" and [part.kind for part in corner.parts] == ["box", "cylinder"]
    # The transforms of solids within solids are those of their parts, and what has no material has the solid's.
    assert corner.transform is None and corner.material is None and corner.parts[0].material is None
    np.testing.assert_array_equal(corner.parts[1].transform[:, 3], (0.75, 0, 0.5))


@pytest.mark.parametrize(
    "make, operation",
    [(lambda a, b: a - b, "difference"), (lambda a, b: a & b, "intersection"), (lambda a, b: a | b, "merge")],
)
def test_operators(make, operation):
    a, b, c = glint.Sphere(), glint.Box(), glint.Torus()
    assert make(a, b) == glint.Solid(operation, [a, b])
    assert make(make(a, b), c) == glint.Solid(operation, (a, b, c))
    named = make(a, b)
    named.name = "two"
    assert len(make(named, c).parts) == 2  # it has something of its own
    assert make(a, ~b).parts[1] == glint.Solid("inverse", [b])


def test_parts_are_copies_with_their_materials():
    ball = glint.Sphere(material=RED, name="ball")
    solid = ball - glint.Box(color=(0, 0, 1))
    ball.radius = 5
    solid.parts[0].radius = 6
    assert solid.parts[0].radius == 1 and solid.parts[0].name == ""
    assert solid.parts[0].material is RED
    assert solid.parts[1].color is None and solid.parts[1].material == glint.Material(color=(0, 0, 1))
    whole = glint.Solid("merge", [glint.Solid("merge", [ball, glint.Sphere()], color=(0, 1, 0))])
    assert [part.material.color for part in whole.parts[0].parts] == [(0, 1, 0)] * 2
    solid.parts = [ball]
    solid.operation = "inverse"
    assert solid == ~ball
    copied = copy.deepcopy(carved() | ball)
    assert copied.parts[1].material == RED and copied.parts[1].material is not RED


def box_of_triangles(*, closed=True):
    """The box from (0, 0, 0) to (2, 2, 2)."""
    corners = [(x, y, z) for z in (0, 2) for y in (0, 2) for x in (0, 2)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    faces = [face for a, b, c, d in sides for face in ((a, b, c), (a, c, d))]
    return glint.Mesh(corners, faces if closed else faces[1:])


def test_a_closed_mesh_is_a_part():
    solid = glint.Box((-1, -1, -1), (1, 1, 1), material=RED) - box_of_triangles()
    assert type(solid.parts[1]) is glint.Mesh
    scene = scene_with(solid)
    again = glint.loads(scene.to_glint())
    assert type(again.shapes[0].parts[1]) is glint.Mesh
    assert same_picture(scene, again)
    plain = scene_with(glint.Box((-1, -1, -1), (1, 1, 1), material=RED) - glint.Box((0, 0, 0), (2, 2, 2)))
    difference = np.abs(scene.render().array - plain.render().array).max(axis=2)
    assert np.count_nonzero(difference > 1e-9) < 4


def test_what_is_wrong_is_refused():
    ball, plain = glint.Sphere(), "expected a shape that encloses a space: a Sphere, Box, .*; found a "
    for make, error, message in (
        (lambda: glint.Disc() - ball, ValueError, f"difference: {plain}Disc"),
        (lambda: ball - box_of_triangles(closed=False), ValueError, f"difference: {plain}Mesh"),
        (lambda: ball & glint.Triangle(), ValueError, f"intersection: {plain}Triangle"),
        (lambda: ~glint.Cylinder(caps=False), ValueError, f"inverse: {plain}Cylinder without caps"),
        (lambda: ball | 3, TypeError, "merge: expected a shape, found 3"),
        (lambda: 3 - ball, TypeError, "unsupported operand"),
        (lambda: glint.Solid("merge", [ball, 3]), TypeError, r"parts\[1\]: expected a shape, found 3"),
        (lambda: glint.Solid("merge", [ball, glint.Disc()]), ValueError, r"parts\[1\]: expected a shape that"),
        (lambda: glint.Solid("merge", ball), TypeError, "parts: expected a sequence of shapes, found Sphere"),
        (lambda: glint.Solid("merge", []), ValueError, "parts: expected one shape or more, found none"),
        (lambda: glint.Solid("inverse", [ball, ball]), ValueError, "parts: expected one shape for 'inverse', found 2"),
        (lambda: glint.Solid("merge", [ball] * 4097), ValueError, "parts: expected at most 4096 operands, found 4097"),
        (lambda: glint.Solid("add", [ball]), ValueError, "operation: expected one of .*merge.*, found 'add'"),
        (lambda: glint.Solid(3, [ball]), TypeError, "operation: expected .*, found 3"),
        (lambda: glint.Solid("merge"), TypeError, "'parts' is missing"),
        (lambda: setattr(ball - ball, "operation", "inverse"), ValueError, "expected one shape"),
    ):
        with pytest.raises(error, match=message):
            make()
    deep = ball
    with pytest.raises(ValueError, match="nested at most 100 deep"):
        for _ in range(101):
            deep = ~deep


def test_changes_after_a_picture():
    scene = scene_with(glint.Plane((0, -1, 0)), carved(), glint.Sphere((2, 0, 0), 0.5))
    scene.render()
    solid = scene.shapes[1]
    red = solid.parts[0].material

    def agrees():
        return same_picture(scene, scene_with(*(copy.deepcopy(shape) for shape in scene.shapes)))

    changes = [
        lambda: setattr(solid, "material", glint.Material(color=(1, 1, 0))),
        lambda: setattr(solid, "color", (0, 1, 1)),
        lambda: setattr(solid, "color", None),
        lambda: setattr(solid, "transform", MOVED),
        lambda: setattr(red, "color", (0, 0, 1)),
        lambda: setattr(solid, "parts", solid.parts[::-1]),
        lambda: setattr(solid, "operation", "merge"),
        lambda: scene.shapes.__setitem__(1, ~glint.Box() & glint.Sphere()),
        lambda: scene.shapes.__setitem__(0, glint.Sphere((0, 0, -1), 2) - glint.Box()),
        lambda: scene.shapes.__setitem__(1, glint.Sphere()),
        lambda: scene.add(glint.Sphere((0, 1, 1), 0.7, material=RED) - glint.Sphere((0, 1, 1.5), 0.5)),
        lambda: scene.shapes.__delitem__(0),
    ]
    for number, change in enumerate(changes):
        before = scene.render().array
        change()
        assert agrees(), number
        assert not np.array_equal(before, scene.render().array), number


def test_arrays_of_shapes_with_solids():
    scene = scene_with(glint.Sphere((1, 0, 0), 0.5), carved())
    with pytest.raises(TypeError, match="centers: expected spheres, discs and tori, found the shape 1, which is of the kind solid"):
        scene.shapes.centers
    scene.shapes.colors = [(1, 1, 0), (0, 1, 1)]
    assert scene.shapes[1].color == (0, 1, 1)
    parts = scene.shapes[1].parts
    maps = np.zeros((2, 3, 4)) + np.eye(4)[:3]
    maps[:, 1, 3] = 0.5, -0.5
    scene.shapes.transforms = maps
    np.testing.assert_array_equal(scene.shapes.transforms, maps)
    scene.shapes.materials = glint.Material(color=(0.5, 0.5, 1))
    assert scene.shapes[1].parts == parts  # with transforms and materials of their own
    assert same_picture(scene, scene_with(*(copy.deepcopy(shape) for shape in scene.shapes)))


def test_scenes_with_solids_are_pickled_and_compared():
    scene = scene_with(carved())
    assert pickle.loads(pickle.dumps(scene.shapes[0])) == carved()
    assert same_picture(pickle.loads(pickle.dumps(scene)), scene)
    other = copy.deepcopy(scene)
    assert other == scene
    other.shapes[0].parts = [glint.Sphere(), *other.shapes[0].parts[1:]]
    assert other != scene
