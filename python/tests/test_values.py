# SPDX-License-Identifier: Apache-2.0
"""Values as Python's own: pickles, copies, representations, signatures."""

import copy
import inspect
import pickle
import typing

import numpy as np
import pytest

import glint
from glint import _words

MATRIX = [[1, 0, 0, 2.5], [0, 0, -1, 0], [0, 1, 0, 0.1]]
GOLD = glint.Material(color=(0.9, 0.7, 0.2), diffuse=(1, 1, 1), specular=0.6, mirror=0.25, name="gold")
VERTICES = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
VALUES = [
    glint.Light("spot", color=(1, 0.5, 0.1), position=(1, 2, 3), inner_angle=10, casts_shadows=False, name="key"),
    glint.Light("ambient", color=0.3),
    glint.Light("point", color=0.5, specular_color=0.1),
    glint.Material(),
    GOLD,
    glint.Camera(position=(1, 2, 3), fov=30),
    glint.Camera(position=(1, 2, 3), width=4, projection="orthographic", fov_axis="y", lighting_eye=(0, 0, 1)),
    glint.Camera(frame=glint.CameraFrame(right=(1, 0, 0), up=(0, 1, 0), forward=(0, 0, -1))),
    glint.Fog("linear", color=0.7, start=1, end=9),
    glint.Occlusion("fixed", samples=9),
    glint.BackgroundGradient("plane", up=(0, 0, 1), bottom_color=(1, 0, 0)),
    glint.Sphere((1, 2, 3), 0.1, material=GOLD, transform=MATRIX, name="ball"),
    glint.Plane((0, -1, 0), (0, 1, 1)),
    glint.Cylinder((0, 0, 0), (0, 2, 0), 0.5, caps=False, color="#336699"),
    glint.Cone((0, 0, 0), (0, 2, 0), 0.5, 0.1),
    glint.Disc((0, 0, 0), (0, 0, 1), 2),
    glint.Disc((0, 0, 0), (0, 0, 1), 2, 0.5),
    glint.Torus((1, 0, 0), (0, 0, 1), 2, 0.25),
    glint.Quadric((1, -1, 1), constant=-0.25),
    glint.Quartic(x4=1, y2=-2, constant=-0.25),
    glint.Box((0, 0, 0), (1, 2, 3)),
    glint.Triangle(VERTICES),
    glint.SmoothTriangle(VERTICES, [(0, 0, 1)] * 3),
    glint.Polygon([*VERTICES, (-1, 0, 0)]),
    glint.Sphere((1, 2, 3), 0.1, material=GOLD, transform=MATRIX) - (glint.Box() & ~glint.Torus()),
    glint.Solid("clip", [glint.Sphere(), glint.Plane()], material=GOLD, color=(1, 0, 0), transform=MATRIX, name="bowl"),
]
TEXTURE = glint.Texture(
    np.arange(24, dtype=np.uint8).reshape(2, 4, 3), mapping="planar", wrap_u="clamp", world_from_texture=MATRIX, name="t"
)
MESH = glint.Mesh(np.array(VERTICES, np.float32), [(0, 1, 2)], [(0, 0, 1)] * 3, texture_coordinates=[(0, 0), (1, 0), (0, 1)])


@pytest.mark.parametrize("value", [*VALUES, TEXTURE, MESH], ids=repr)
@pytest.mark.parametrize("protocol", [2, pickle.HIGHEST_PROTOCOL])
def test_values_are_pickled_and_copied(value, protocol):
    for made in (pickle.loads(pickle.dumps(value, protocol)), copy.copy(value), copy.deepcopy(value)):
        assert type(made) is type(value) and made is not value
        assert made == value


@pytest.mark.parametrize("value", VALUES, ids=repr)
def test_representations_can_be_evaluated(value):
    assert eval(repr(value), vars(glint)) == value


def test_what_values_share_is_pickled_once():
    a, b = pickle.loads(pickle.dumps((glint.Sphere(material=GOLD), glint.Sphere(material=GOLD))))
    assert a.material is b.material
    textured = pickle.loads(pickle.dumps(glint.Material(texture=TEXTURE)))
    assert textured.texture == TEXTURE and textured.texture.image.dtype == np.uint8


def test_a_mesh_with_normals_of_its_own_numbers_is_pickled():
    cube = glint.loads("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf 2//1 4//1 3//1\n", "obj").shapes[0]
    assert pickle.loads(pickle.dumps(cube)) == cube


class Named(glint.Sphere):
    """A user's class, with attributes of its own."""

    def __init__(self, label, **keywords):
        super().__init__((1, 2, 3), **keywords)
        self.label = label


def test_classes_of_users_are_pickled_with_their_attributes():
    made = pickle.loads(pickle.dumps(Named("a", radius=2)))
    assert type(made) is Named and made.label == "a" and made.radius == 2 and made.center == (1, 2, 3)


def test_an_object_without_values_is_shown():
    """As a debugger does if the constructor failed."""
    assert repr(glint.Sphere.__new__(glint.Sphere)) == "<Sphere without values>"


def test_errors_are_pickled_with_their_diagnostics():
    with pytest.raises(glint.GlintError) as raised:
        glint.loads("sphere { center = (0, oops, 0) radius = 1 }")
    for made in (pickle.loads(pickle.dumps(raised.value)), copy.copy(raised.value), copy.deepcopy(raised.value)):
        assert (made.code, str(made)) == (raised.value.code, str(raised.value))
        a, b = made.diagnostics[0], raised.value.diagnostics[0]
        assert (str(a), a.line, a.column, a.severity, a.item) == (str(b), b.line, b.column, b.severity, b.item)
    warning = glint.GlintWarning("text", a)
    assert pickle.loads(pickle.dumps(warning)).diagnostic.line == a.line


@pytest.mark.filterwarnings("ignore::glint.GlintWarning")
def test_answers_are_pickled(scene):
    answers = [glint.explain(scene, 3, 4), *glint.check(scene), scene.cast((0, 0, 9), [(0, 0, -1)])]
    answers += [glint.compare(scene.render(), scene.render()), *glint.grade({"ada": scene.render()}, scene)]
    for answer in answers:
        for made in (pickle.loads(pickle.dumps(answer)), copy.deepcopy(answer)):
            assert repr(made)[:99] == repr(answer)[:99] and type(made) is type(answer)
    assert pickle.loads(pickle.dumps(scene.lights)) == list(scene.lights)
    assert pickle.loads(pickle.dumps(scene.settings)) == dict(scene.settings)


@pytest.mark.filterwarnings("ignore::glint.GlintWarning")
def test_diagnoses_are_pickled_with_their_trees():
    scene = glint.loads("camera { position = (0, 0, 4) look_at = (0, 0, 0) fov_x = 50 } sphere { center = (0, 0, 0) radius = 1 }")
    with glint.TraceLog([(20, 18)], size=(64, 48)) as log:
        log.pixel(20, 18)
        with log.ray("camera"):
            log.value("t", 9.0)
    answer = glint.diagnose(scene, log)
    for made in (pickle.loads(pickle.dumps(answer)), copy.deepcopy(answer)):
        assert str(made) == str(answer) and made.tree(20, 18) == answer.tree(20, 18)
        assert pickle.loads(pickle.dumps(made)).tree(20, 18) == answer.tree(20, 18)
        with pytest.raises(KeyError):
            made.tree(0, 0)


def test_signatures_have_names_and_defaults():
    assert str(inspect.signature(glint.Sphere)) == (
        "(center=(0.0, 0.0, 0.0), radius=1.0, *, material=None, color=None, transform=None, name='')"
    )
    light = inspect.signature(glint.Light).parameters
    assert light["kind"].default == "point" and light["casts_shadows"].default is True
    factor = inspect.signature(glint.Material).parameters["diffuse"].default
    assert glint.Material(diffuse=factor).diffuse == pytest.approx(glint.Material().diffuse)
    assert repr(glint.Material()) == "Material()"
    assert list(inspect.signature(glint.Texture).parameters)[0] == "image"
    assert "radius: A number > 0" in glint.Sphere.__init__.__doc__
    assert list(inspect.signature(glint.Scene.render).parameters)[1] == "size"


@pytest.mark.parametrize(
    "words, find",
    [
        (_words.Shading, lambda w: glint.Scene().settings.__setitem__("shading", w)),
        (_words.LightKind, glint.Light),
        (_words.FogKind, glint.Fog),
        (_words.OcclusionMethod, glint.Occlusion),
        (_words.GradientKind, glint.BackgroundGradient),
        (_words.Projection, lambda w: glint.Camera(projection=w)),
        (_words.FovAxis, lambda w: glint.Camera(fov_axis=w)),
        (_words.TextureMapping, lambda w: glint.Texture(TEXTURE.image, mapping=w)),
        (_words.TextureWrap, lambda w: glint.Texture(TEXTURE.image, wrap_v=w)),
        (_words.TextureFilter, lambda w: glint.Texture(TEXTURE.image, filter=w)),
        (_words.TextureMix, lambda w: glint.Texture(TEXTURE.image, mix=w)),
        (_words.TextureEncoding, lambda w: glint.Texture(TEXTURE.image, encoding=w)),
        (_words.TextureAlpha, lambda w: glint.Texture(TEXTURE.image, alpha=w)),
        (_words.SolidOperation, lambda w: glint.Solid(w, [glint.Sphere()])),
        (_words.PictureFormat, lambda w: glint.Image([[1.0]]).to_bytes(w)),
    ],
)
def test_words_for_type_checkers_are_the_library_s(words, find):
    known = typing.get_args(words)
    for word in known:
        find(word)
    with pytest.raises((ValueError, glint.GlintError)) as raised:
        find("oops")
    text = str(raised.value).partition("found")[0].partition("expected")[2]
    listed = text.replace("one of", " ").replace(" or ", " ").replace("|", " ").replace(",", " ").replace("'", " ").split()
    assert sorted(listed) == sorted(known)
