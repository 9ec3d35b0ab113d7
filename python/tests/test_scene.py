# SPDX-License-Identifier: Apache-2.0
"""Scenes, their objects and attributes."""

import copy
import pickle

import numpy as np
import pytest

import glint


def test_reads_and_writes_attributes(scene):
    scene.camera.position = [1, 2, 3]
    assert scene.camera.position == (1, 2, 3)
    scene.camera.position += (0, 1, 0)
    assert scene.camera.position == (1, 3, 3)
    assert isinstance(scene.camera.position, glint.Vec3)
    scene.lights["key"].intensity *= 2
    assert scene.lights[0].color == (2, 2, 2)
    assert scene.lights[0].specular_color == (2, 2, 2)
    scene.materials["red"].mirror = 0.5
    assert scene.shapes["ball"].material.mirror == 0.5
    scene.background = "#ff0000"
    assert scene.background == (1, 0, 0)


def test_attributes_are_those_of_the_tables():
    # One of each type; the stub test holds all of them against the stubs.
    light = glint.Light("point", attenuation=(1, 0, 0.5))
    assert light.attenuation.c2 == 0.5
    spot = glint.Light("spot", axis=(0, -1, 0), outer_angle=30, fade_distance=2, fade_power=1.5, casts_shadows=False)
    assert spot.axis == (0, -1, 0) and spot.outer_angle == 30 and spot.casts_shadows is False
    assert "casts_shadows=False" in repr(spot)
    panel = glint.Light("parallelogram", side_u=(1, 0, 0), side_v=(0, 0, 2), samples_u=5, one_sided=True)
    assert panel.samples_u == 5 and isinstance(panel.samples_v, int) and panel.side_v == (0, 0, 2) and panel.one_sided
    with pytest.raises(ValueError, match="samples_u: expected a whole number from 1 to 64, found 2.5"):
        panel.samples_u = 2.5
    assert glint.Material(casts_shadow=False).casts_shadow is False
    camera = glint.Camera(fov=40, lighting_eye=(0, 0, 1))
    assert camera.fov == 40 and camera.lighting_eye == (0, 0, 1)
    camera.lighting_eye = None
    assert camera.lighting_eye is None
    assert glint.Material(ior=1.5, transmission=0.9).ior == 1.5
    pane = glint.Material(color=(1, 0, 0), filter=0.7, transmit=0.1)
    assert pane.filter == 0.7 and pane.transmit == 0.1
    mesh = glint.Material(transmit=0.5, hollow=True, interior=3)
    assert mesh.hollow is True and mesh.interior == 3 and isinstance(mesh.interior, int)


@pytest.mark.parametrize(
    "set_it, message",
    [
        (lambda m: setattr(m, "mirror", 2), "mirror: expected a number from 0 to 1, found 2"),
        (lambda m: setattr(m, "mirror", "x"), "mirror: expected a number from 0 to 1, found 'x'"),
        (lambda m: setattr(m, "color", (1, 2)), "color: expected a color: three numbers"),
        (lambda m: setattr(m, "color", "rde"), "such as 'red', found 'rde'"),
        (lambda m: setattr(m, "shininess", float("nan")), "shininess: expected"),
        (lambda m: setattr(m, "casts_shadow", 1), "casts_shadow: expected True or False, found 1"),
    ],
)
def test_refuses_values_out_of_range(set_it, message):
    with pytest.raises(ValueError, match=message):
        set_it(glint.Material())


def test_refuses_unknown_words(scene):
    with pytest.raises(TypeError, match="did you mean .mirror."):
        glint.Material(miror=1)
    with pytest.raises(TypeError, match="Sphere has no attribute 'radios'; did you mean 'radius'"):
        glint.Sphere((0, 0, 0), radios=1)
    with pytest.raises(AttributeError):
        glint.Material().miror = 1
    with pytest.raises(KeyError, match="no light 'kee'"):
        scene.lights["kee"]
    with pytest.raises(IndexError):
        scene.shapes[2]


def test_factors_of_the_color_follow_it():
    material = glint.Material(color=(1, 0, 0), specular=0.5)
    assert material.diffuse == (0.8, 0, 0) and material.specular == (0.5, 0, 0)
    material.color = (0, 1, 0)
    assert material.diffuse == (0, 0.8, 0) and material.specular == (0, 0.5, 0)
    plastic = glint.Material(color=(1, 0, 0), specular=(1, 1, 1))
    plastic.color = (0, 1, 0)
    assert plastic.specular == (1, 1, 1)


def test_a_color_is_as_in_the_scene_language():
    text = "camera { position = (0, 0, 5)  look_at = (0, 0, 0)  fov_x = 50 }  light { type = ambient }  sphere { center = (0, 0, 0) radius = 1 color = (0.3, 0.6, 0.9) }"
    read = glint.loads("material m { color = (0.3, 0.6, 0.9) specular = 0.25 }\n" + text).materials["m"]
    made = glint.Material(color=(0.3, 0.6, 0.9), specular=0.25, name="m")
    assert made == read


def test_repr_equality_and_copies(scene):
    ball = scene.shapes["ball"]
    assert ball is scene.shapes[0]
    assert repr(ball).startswith("Sphere(center=(0.0, 0.0, 0.0), radius=1.0, material=Material(name='red'")
    assert repr(scene.lights["key"]) == "Light('point', name='key', position=(4.0, 5.0, 3.0))"
    twin = copy.copy(ball)
    assert twin == ball and twin is not ball
    twin.radius = 2
    assert twin != ball and ball.radius == 1
    other = copy.deepcopy(scene)
    assert other == scene
    other.lights[0].position = (0, 0, 0)
    assert other != scene and scene.lights[0].position == (4, 5, 3)
    made = eval(repr(scene.camera), {"Camera": glint.Camera})
    assert made == scene.camera


def test_pickles(scene):
    scene.settings["shading"] = "phong"
    scene.conventions["limit"] = "drop"
    image = scene.render()
    other = pickle.loads(pickle.dumps(scene))
    assert other == scene
    assert other.render() == image
    assert pickle.loads(pickle.dumps(image)) == image


def test_fog(scene):
    assert scene.fog is None
    clear = scene.render()
    fog = glint.Fog("exp", color=0.5, density=0.2, start=1)
    scene.fog = fog
    assert scene.fog is fog
    foggy = scene.render()
    assert foggy != clear
    fog.density = 0
    assert scene.render() != foggy  # the object is the scene's
    fog.density = 0.2
    assert scene.render() == foggy
    other = copy.deepcopy(scene)
    assert other == scene and other.fog is not fog
    other.fog.kind = "exp2"
    assert other != scene and other.render() != foggy
    assert glint.loads(scene.to_glint()).fog == fog
    assert eval(repr(fog), {"Fog": glint.Fog}) == fog
    assert glint.Scene(fog=fog).fog == fog
    scene.fog = None
    assert scene.render() == clear
    with pytest.raises(ValueError, match="kind: expected 'linear', 'exp' or 'exp2', found 'thick'"):
        glint.Fog("thick")
    with pytest.raises(TypeError, match="did you mean .density."):
        glint.Fog(densty=1)
    scene.fog = glint.Fog("linear", start=5, end=5)
    with pytest.raises(glint.GlintError, match="expected a number above start 5, found 5"):
        scene.render()


def test_occlusion_and_gradient(scene):
    assert scene.occlusion is None and scene.gradient is None
    plain = scene.render()
    scene.occlusion = glint.Occlusion("fixed", samples=8, color=0.5, reach=20, direct=0.5)
    occluded = scene.render()
    assert occluded != plain
    scene.occlusion.samples = 9
    assert scene.render() != occluded  # the object is the scene's
    scene.occlusion.method = "hashed"
    scene.gradient = glint.BackgroundGradient(up=(0, 1, 1), bottom=-0.25)
    assert glint.loads(scene.to_glint()).occlusion == scene.occlusion
    assert glint.loads(scene.to_glint()).gradient == scene.gradient
    assert eval(repr(scene.gradient), {"BackgroundGradient": glint.BackgroundGradient}) == scene.gradient
    other = copy.deepcopy(scene)
    assert other == scene and other.render() == scene.render()
    other.gradient.repeats = True
    assert other != scene and other.render() != scene.render()
    assert glint.Occlusion().reach == float("inf")
    scene.occlusion = scene.gradient = None
    assert scene.render() == plain
    with pytest.raises(ValueError, match="method: expected 'hashed' or 'fixed', found 'random'"):
        glint.Occlusion("random")
    with pytest.raises(ValueError, match="whole number from 1 to 4096"):
        glint.Occlusion(samples=0)


def test_lights_are_a_list(scene):
    scene.lights.append(glint.Light("ambient", color=0.2, name="fill"))
    assert [light.name for light in scene.lights] == ["key", "fill"]
    scene.lights.insert(0, glint.Light("directional", to_light=(0, 1, 0)))
    assert [light.kind for light in scene.lights] == ["directional", "point", "ambient"]
    del scene.lights["key"]
    assert len(scene.lights) == 2 and "key" not in scene.lights
    scene.lights = []
    assert len(scene.lights) == 0


def test_shapes_can_be_removed(scene):
    del scene.shapes["ball"]
    assert [shape.name for shape in scene.shapes] == ["floor"]
    scene.shapes.clear()
    assert len(scene.shapes) == 0


def test_every_kind_of_shape():
    scene = glint.Scene(glint.Light("ambient"), size=(32, 32))
    shapes = [
        glint.Sphere((0, 0, 0), 1),
        glint.Plane((0, -3, 0)),
        glint.Cylinder((0, 0, 0), (0, 1, 0), 0.5),
        glint.Cone((0, 0, 0), (0, 1, 0), 0.5, caps=False),
        glint.Disc((0, 2, 0), (0, 0, 1), 0.5),
        glint.Box((0, 0, 0), (1, 1, 1)),
        glint.Triangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)]),
        glint.SmoothTriangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 0, 1)] * 3),
        glint.Polygon([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]),
        glint.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0.1), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)]),
        glint.Torus((0, 1, 0), (0, 1, 0), 2, 0.5),
        glint.Quadric((1, 2, 1), (0.5, 0, 0), (0, -1, 0), -0.5),
        glint.Quartic(x4=1, y4=1, z4=1, x2yz=0.5, constant=-1),
        glint.Disc((0, 1, 0), (0, 1, 0), 2, hole=0.5),
        glint.Sphere() - glint.Box(),
    ]
    for shape in shapes:
        scene.add(shape)
    assert [s.kind for s in scene.shapes] == [
        "sphere", "plane", "cylinder", "cone", "disc", "box", "triangle", "smooth_triangle", "polygon", "mesh",
        "torus", "quadric", "quartic", "disc", "solid",
    ]  # fmt: skip
    assert glint.loads(scene.to_glint()).to_glint() == scene.to_glint()
    scene.shapes[8].vertices = [(0, 0, 0), (2, 0, 0), (2, 2, 0)]
    np.testing.assert_array_equal(scene.shapes[8].vertices[1], (2, 0, 0))
    assert scene.shapes[2].caps and not scene.shapes[3].caps


def test_meshes():
    corners = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], np.float32)
    mesh = glint.Mesh(corners, [(0, 1, 2), (0, 2, 3)], normals=[(0, 0, 1)] * 4, color=(1, 0, 0), name="square")
    assert mesh.vertices.dtype == np.float32 and not mesh.vertices.flags.writeable
    np.testing.assert_array_equal(mesh.triangles, [(0, 1, 2), (0, 2, 3)])
    np.testing.assert_array_equal(mesh.normals[3], (0, 0, 1))
    scene = glint.Scene(glint.Light("directional", to_light=(0, 0, 1)), size=(32, 32))
    scene.add(mesh)
    moved = scene.add(glint.Mesh(corners, [(0, 1, 2)]))
    moved.transform = [(1, 0, 0, 2), (0, 1, 0, 0), (0, 0, 1, 0)]
    assert scene.shapes["square"] == mesh and moved.normals is None
    assert scene.to_glint().count("mesh") == 2
    for vertices, triangles, message in (
        (corners, [(0, 1, 4)], "triangles: triangle 0: expected a vertex below 4, found 4"),
        (corners, [(0, 1, -1)], "found -1"),
        (corners, np.int32([(0, 1, -1)]), "triangle 0: expected a vertex below 4, found -1"),
        (corners, np.uint32([(0, 1, 2), (0, 4294967295, 3)]), "triangle 1: .* found 4294967295"),
        (corners, np.int64([(0, 1, 2**62)]), "found 4611686018427387904"),
        (corners, [(0, 1, 2), (0, 1.7, 3)], "triangles: triangle 1: expected a whole number, found 1.7"),
        (corners, [(0, 1, np.nan)], "triangles: triangle 0: expected a vertex below 4, found nan"),
        ([*corners[:3], (0, np.nan, 0)], [(0, 1, 2)], "vertices: row 3: expected a number from -1e12 to 1e12, found nan"),
        (np.float32([*corners[:3], (0, np.inf, 0)]), [(0, 1, 2)], "vertices: row 3: expected .*, found inf"),
        (corners[:, :2], [(0, 1, 2)], "vertices: expected an array of N x 3 numbers, found 2 dimensions, 2 columns"),
    ):
        with pytest.raises(ValueError, match=message):
            glint.Mesh(vertices, triangles)
        with pytest.raises(ValueError, match=message):
            glint.Scene().add_mesh(vertices, triangles)
    for wrong in ({"normals": [(0, 0, 1)]}, {"colors": [(0, 0, 1)]}):
        with pytest.raises(ValueError, match=f"{[*wrong][0]}: expected 4"):
            glint.Mesh(corners, [(0, 1, 2)], **wrong)


def test_meshes_with_colors():
    corners = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], np.float32)
    faces = np.array([(0, 1, 2), (0, 2, 3)])
    scene = glint.Scene(glint.Light("ambient", intensity=1), size=(32, 32))
    scene.camera = glint.Camera(projection="orthographic", position=(0, 0, 5), look_at=(0, 0, 0), width=2)
    flat = glint.Material(ambient=(1, 1, 1), color=(1, 1, 1))
    colors = corners[:, :1] / 2 + 0.5 + np.zeros((4, 3), np.float32)  # dark at the left, bright at the right
    mesh = scene.add_mesh(corners, faces, colors=colors, material=flat)
    np.testing.assert_array_equal(mesh.colors, colors)
    row = scene.render().array[16, :, 1]
    np.testing.assert_allclose(row, (np.arange(32) + 0.5) / 32, atol=1e-6)
    assert len(scene.shapes) == 1 and scene.shapes[0].material == flat


def test_transforms(scene):
    matrix = np.eye(4)
    matrix[0, 3] = 1
    scene.shapes["ball"].transform = matrix
    moved = scene.render()
    scene.shapes["ball"].transform = None
    scene.shapes["ball"].center = (1, 0, 0)
    assert np.abs(scene.render().array - moved.array).max() < 1e-4


def test_settings_and_profiles(scene):
    assert scene.settings["size"] == (64, 48)
    scene.settings["shading"] = "phong"
    scene.conventions["limit"] = "drop"
    assert dict(scene.settings)["shading"] == "phong" and scene.conventions["limit"] == "drop"
    for key, value in (("transparent_surfaces", 4096), ("seed", 0), ("reflections", 4), ("aa", 1)):
        found = {**scene.settings, **scene.conventions}[key]
        assert found == value and isinstance(found, int)
    scene.settings["aa"] = "adaptive:3:0.1:jitter"
    assert scene.settings["aa"] == "adaptive:3:0.1:jitter" and scene.conventions["gamma"] == 1.0
    with pytest.raises(glint.GlintError, match="phong"):
        scene.settings["shading"] = "fong"
    with pytest.raises(KeyError, match="did you mean `specular_gate`"):
        scene.conventions["specular_gat"] = True
    assert "epfl" in glint.profiles and glint.profiles["cgfs"]["pixel_sample"] == "corner"
    assert glint.setting_infos["epsilon"].is_convention
