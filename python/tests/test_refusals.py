# SPDX-License-Identifier: Apache-2.0
"""What is wrong is refused where it is said, in plain words."""

import re
import warnings

import numpy as np
import pytest

import glint
from glint import _expect

pytestmark = pytest.mark.filterwarnings("ignore::glint.GlintWarning")

TRIANGLE = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
IMAGE = glint.Image([[0.5, 1]])


def set_attribute(make, name, value=1):
    return lambda: setattr(make(), name, value)


@pytest.mark.parametrize(
    "call, message",
    [
        (set_attribute(glint.Scene, "backgroud"), "Scene has no attribute 'backgroud'; did you mean 'background'?"),
        (set_attribute(glint.Camera, "positon"), "Camera has no attribute 'positon'; did you mean 'position'?"),
        (set_attribute(glint.Light, "colour"), "Light has no attribute 'colour'; did you mean 'color'?"),
        (set_attribute(glint.Material, "shinyness"), "Material has no attribute 'shinyness'; did you mean 'shininess'?"),
        (set_attribute(glint.Sphere, "raduis"), "Sphere has no attribute 'raduis'; did you mean 'radius'?"),
        (set_attribute(glint.Fog, "densty"), "Fog has no attribute 'densty'; did you mean 'density'?"),
        (lambda: glint.Scene().ligths, "Scene has no attribute 'ligths'; did you mean 'lights'?"),
        (lambda: glint.Sphere().centre, "Sphere has no attribute 'centre'; did you mean 'center'?"),
        (lambda: IMAGE.widht, "Image has no attribute 'widht'; did you mean 'width'?"),
        (set_attribute(glint.Sphere, "kind", "box"), "Sphere cannot change its attribute 'kind'"),
    ],
)
def test_unknown_attributes(call, message):
    with pytest.raises(AttributeError) as raised:
        call()
    assert str(raised.value) == message


def test_classes_of_users_have_attributes_of_their_own():
    class Mine(glint.Scene):
        pass

    mine = Mine()
    mine.label = "a"
    assert mine.label == "a"


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: glint.Sphere(material="gold"), "material: expected a Material or None, found 'gold'"),
        (lambda: glint.Camera((0, 0, 5)), "Camera() takes keywords only, such as position=(0.0, 0.0, 0.0); found (0, 0, 5)"),
        (lambda: glint.Camera(projection=3), "projection: expected a string, found 3"),
        (lambda: glint.Camera(frame=3), "frame: expected a CameraFrame or None, found 3"),
        (lambda: glint.Light(3), "kind: expected a string, found 3"),
        (lambda: glint.Light(name=3), "name: expected a string, found 3"),
        (lambda: glint.Material(colr=3), "Material has no attribute 'colr'; did you mean 'color'?"),
        (lambda: glint.Sphere((0, 0, 0), 1, 2), "Sphere() takes center, radius and then keywords; found 2"),
        (lambda: glint.Sphere((0, 0, 0), center=1), "Sphere() has two values for 'center'"),
        (lambda: glint.Mesh(TRIANGLE), "Mesh() needs vertices and triangles; 'triangles' is missing"),
        (lambda: glint.Cylinder(caps="x"), "caps: expected True or False, found 'x'"),
        (set_attribute(glint.Sphere, "name", 3), "name: expected a string, found 3"),
        (set_attribute(glint.Scene, "fog", 3), "fog: expected a Fog or None, found 3"),
        (set_attribute(glint.Scene, "camera", None), "camera: expected a Camera, found None"),
        (lambda: glint.Scene().lights.append(3), "lights: expected a Light, found 3"),
        (lambda: glint.Scene().shapes.append(3), "shapes: expected a Shape, found 3"),
        (lambda: glint.Scene().spheres([(0, 0, 0)], material="gold"), "material: expected a Material or None, found 'gold'"),
        (lambda: glint.Scene().render(crop="10x10"), "crop: expected (width, height, x, y), four whole numbers of pixels, or"),
        (lambda: glint.Scene().render(crop=(0, 0, 10, 10)), "crop: expected (width, height, x, y) with a width and a height above 0, found (0, 0"),
        (lambda: glint.diagnose(glint.Scene(), "pixel 1 2\nmiss\n"), "log: expected a TraceLog or the path of a log, found the text of one"),
        (lambda: glint.Image(np.full((2, 2, 3), 200)), "a picture of whole numbers is an array of uint8 (0 to 255) or uint16 (0 to 65535), found int64"),
        (lambda: glint.compare([[0, 1]], IMAGE), "a picture of whole numbers is an array of uint8"),
        (lambda: glint.Image(np.zeros((2, 2, 3), np.uint32)), "a picture of whole numbers is an array of uint8"),
        (lambda: glint.Image(np.full((2, 2, 3), 200.0)), "the numbers of a picture of floats are from 0 to 1, found whole numbers up to 200:"),
        (lambda: glint.Scene().render(threads="a"), "threads: expected a whole number, found 'a'"),
        (lambda: glint.Scene().render(isa=3), "isa: expected a string, found 3"),
        (lambda: glint.Scene().render(aov=3), "aov: expected a string or a sequence of a string, found 3"),
        (lambda: glint.Scene().render(progress=3), "progress: expected True, False or a function, found 3"),
        (lambda: glint.check(glint.Scene(), progress=3), "progress: expected True, False or a function, found 3"),
        (lambda: glint.animate([], "a.png", progress="yes"), "progress: expected True, False or a function, found 'yes'"),
        (lambda: glint.Scene().cast((0, 0, 0), (0, 0, 1), t_min="a"), "t_min: expected a number, found 'a'"),
        (lambda: glint.explain(glint.Scene(), 1.5, 2), "x: expected a whole number, found 1.5"),
        (lambda: glint.loads("", 3), "format: expected a string, found 3"),
        (lambda: glint.loads(b""), "text: expected a string, found b''"),
        (lambda: IMAGE.to_bytes(bits="x"), "bits: expected a whole number, found 'x'"),
        (lambda: IMAGE.viewable(3), "layer: expected a string, found 3"),
    ],
)
def test_plain_messages(call, message):
    with pytest.raises((TypeError, ValueError)) as raised:
        call()
    assert str(raised.value).startswith(message)
    assert not re.search("pybind|std::|incompatible|arg0|C[+][+]|_glint", str(raised.value))


def test_a_wrong_setting_is_named():
    with pytest.raises(glint.GlintError, match="shading: expected phong .*, found 'lambert'"):
        glint.Scene().render(shading="lambert")


def test_normals_without_a_direction_are_refused_at_once():
    for call in (
        lambda: glint.SmoothTriangle(TRIANGLE, np.zeros((3, 3))),
        lambda: glint.Scene().triangles(TRIANGLE, [(0, 1, 2)], normals=np.zeros((3, 3))),
        lambda: glint.Scene().add_mesh(TRIANGLE, [(0, 1, 2)], normals=np.zeros((3, 3))),
        lambda: glint.Mesh(TRIANGLE, [(0, 1, 2)], np.zeros((3, 3))),
        set_attribute(lambda: glint.SmoothTriangle(TRIANGLE, [(0, 0, 1)] * 3), "normals", np.zeros((3, 3))),
    ):
        with pytest.raises(ValueError, match=r"normals: row 0: expected a normal of any length but 0"):
            call()


def test_cylinders_without_an_axis_are_refused_at_once():
    with pytest.raises(ValueError, match=r"to: row 1: expected another point than that of from_, found \(0.0, 1.0, 0.0\)"):
        glint.Scene().cylinders(np.eye(3), [(2, 0, 0), (0, 1, 0), (0, 0, 3)])


def test_a_wrong_name_has_a_suggestion():
    scene = glint.Scene()
    scene.add(glint.Sphere((0, 0, 0), 1, material=glint.Material(name="gold")))
    with pytest.raises(KeyError, match="the scene has no material 'golt'; did you mean `gold`"):
        scene.materials["golt"]


def test_floats_of_a_brightness_of_255_are_warned_of():
    with pytest.warns(UserWarning, match="most numbers of this picture of floats are above 1"):
        glint.Image(np.full((2, 2, 3), 100.5))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bright = np.zeros((2, 2, 3))
        bright[0, 0] = 100.5
        assert glint.Image(bright).array.max() == 100.5


def test_settings_of_numpy(scene):
    wanted = scene.render(size=(20, 10), shadows=False, convention={"gamma": 2.5})
    numbers = dict(size=np.array([20, 10]), shadows=np.False_, convention={"gamma": np.float64(2.5)})
    assert scene.render(**numbers) == wanted and wanted.size == (20, 10)


def test_pictures_are_not_names_of_files():
    with pytest.raises(TypeError, match=r"Image\(\) takes an array; glint.Image.open\('a.png'\) reads a file"):
        glint.Image("a.png")


def test_a_crop_as_the_command_has_it(scene):
    assert scene.render(crop="20x10+3+4") == scene.render(crop=(20, 10, 3, 4))


def test_out_of_memory_says_the_size():
    with pytest.raises(MemoryError, match="60000x60000 pixels need"):
        glint.Scene().render(size=(60000, 60000))

    @_expect.plain
    def spheres(centers, radii=1.0):
        raise MemoryError("std::bad_alloc")

    with pytest.raises(MemoryError) as raised:
        spheres(np.zeros((5, 3)), radii=2)
    assert str(raised.value) == "spheres(): out of memory for centers of 5 x 3 numbers"


def test_empty_atoms():
    class Atoms:
        def get_positions(self):
            return np.zeros((0, 3))

        def get_atomic_numbers(self):
            return np.zeros(0, int)

    assert len(glint.Scene().add(Atoms())) == 0


def test_layers_show_their_sizes(scene):
    assert repr(scene.render(aov="depth", size=(8, 4)).layers) == "<layers {'depth': 4 x 8 x 1}>"


def test_a_full_disk_leaves_the_old_picture(tmp_path, monkeypatch):
    path = tmp_path / "a.png"
    IMAGE.save(path)
    path.chmod(0o640)
    old = path.read_bytes()
    (tmp_path / "link.png").symlink_to("a.png")
    glint.Image([[0.25]]).save(tmp_path / "link.png")
    assert path.read_bytes() != old and path.stat().st_mode & 0o777 == 0o640
    assert (tmp_path / "link.png").is_symlink()

    def fail(*names):
        raise OSError(28, "No space left on device")

    old = path.read_bytes()
    monkeypatch.setattr("os.replace", fail)
    with pytest.raises(OSError, match="No space left on device.*a.png"):
        IMAGE.save(path)
    monkeypatch.undo()
    assert path.read_bytes() == old and sorted(p.name for p in tmp_path.iterdir()) == ["a.png", "link.png"]
    with pytest.raises(FileNotFoundError):
        IMAGE.save(tmp_path / "no" / "a.png")
