# SPDX-License-Identifier: Apache-2.0
"""Textures, their images, and their coordinates on meshes."""

import copy
import pickle

import numpy as np
import pytest

import glint

#: Red, green; blue, white, from the top.
TEXELS = np.array([[(255, 0, 0), (0, 255, 0)], [(0, 0, 255), (255, 255, 255)]], np.uint8)
PPM = b"P6 2 2 255\n" + TEXELS.tobytes()
CORNERS = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], np.float32)
FACES = [(0, 1, 2), (0, 2, 3)]
UV = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)

TEXT = """
render { size = 48 x 36 }
camera { position = (0, 0, 5)  look_at = (0, 0, 0)  fov_x = 50 }
light { type = directional  to_light = (1, 1, 2) }
texture tiles {
    texels = ("ff0000 00ff00", "0000ff ffffff")
    wrap_u = mirror  filter = nearest  uv_map = ((2, 0, 0.25), (0, 3, 0))
}
texture earth {
    texels = ("0000800080004000 80000000ffffc000")
    mapping = spherical  mix = replace  encoding = linear  alpha = mask  alpha_cutoff = 0.3  translate = (1, 0, 0)
}
material square { color = (1, 0.9, 0.8)  specular = 0.3  texture = tiles }
material ball { color = (1, 1, 1)  texture = earth }
mesh {
    vertices = ((-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0))  triangles = ((0, 1, 2), (0, 2, 3))
    texture_coordinates = ((0, 0), (1, 0), (1, 1), (0, 1))  material = square
}
sphere { center = (1, 0, 1)  radius = 0.7  material = ball }
"""


@pytest.fixture
def square():
    """A square that fills the picture with its texture's colors."""
    scene = glint.Scene(glint.Light("ambient", intensity=1), size=(2, 2))
    scene.camera = glint.Camera(projection="orthographic", position=(0, 0, 5), look_at=(0, 0, 0), width=2)
    white = glint.Material(ambient=(1, 1, 1), color=(1, 1, 1), name="white")
    scene.add_mesh(CORNERS, FACES, texture_coordinates=UV, material=white)
    return scene


def made_of_arrays():
    tiles = glint.Texture(TEXELS, wrap_u="mirror", filter="nearest", uv_map=((2, 0, 0.25), (0, 3, 0)), name="tiles")
    words = np.array([[(0, 0x8000, 0x8000, 0x4000), (0x8000, 0, 0xFFFF, 0xC000)]], np.uint16)
    earth = glint.Texture(
        words, mapping="spherical", mix="replace", encoding="linear", alpha="mask", alpha_cutoff=0.3, name="earth",
        world_from_texture=[(1, 0, 0, 1), (0, 1, 0, 0), (0, 0, 1, 0)],
    )  # fmt: skip
    scene = glint.Scene(glint.Light("directional", to_light=(1, 1, 2)), size=(48, 36))
    scene.camera = glint.Camera(position=(0, 0, 5), look_at=(0, 0, 0), fov=50)
    material = glint.Material(color=(1, 0.9, 0.8), specular=0.3, texture=tiles, name="square")
    scene.add_mesh(CORNERS, FACES, texture_coordinates=UV, material=material)
    scene.add(glint.Sphere((1, 0, 1), 0.7, material=glint.Material(color=(1, 1, 1), texture=earth, name="ball")))
    return scene


def test_pictures_are_those_of_the_language():
    read, made = glint.loads(TEXT), made_of_arrays()
    image = read.render()
    assert made.render() == image
    assert [*made.textures] == [*read.textures]
    assert glint.loads(made.to_glint()).render() == image
    without = made_of_arrays()
    for material in without.materials:
        material.texture = None
    assert without.render() != image


def test_attributes_are_those_of_the_language():
    scene = glint.loads(TEXT)
    earth = scene.textures["earth"]
    assert len(scene.textures) == 2 and earth is scene.textures[1] and "tiles" in scene.textures
    assert scene.materials["ball"].texture is earth
    assert (earth.mapping, earth.mix, earth.encoding, earth.alpha) == ("spherical", "replace", "linear", "mask")
    assert earth.alpha_cutoff == 0.3 and earth.filter == "bilinear" and earth.file == ""
    assert earth.image.shape == (1, 2, 4) and earth.image.dtype == np.uint16 and earth.image[0, 1, 2] == 0xFFFF
    np.testing.assert_array_equal(earth.world_from_texture, [(1, 0, 0, 1), (0, 1, 0, 0), (0, 0, 1, 0)])
    tiles = scene.textures[0]
    assert tiles.wrap_u == "mirror" and tiles.wrap_v == "repeat"
    assert tiles.uv_map == ((2, 0, 0.25), (0, 3, 0))
    assert repr(tiles) == (
        "Texture(<2 x 2 texels>, name='tiles', wrap_u='mirror', filter='nearest', "
        "uv_map=((2.0, 0.0, 0.25), (0.0, 3.0, 0.0)))"
    )
    assert "texture=Texture(<2 x 1 texels with alpha>" in repr(scene.materials["ball"])
    with pytest.raises(KeyError, match="no texture 'moon'"):
        scene.textures["moon"]


def test_rows_are_from_the_top(square):
    square.materials["white"].texture = glint.Texture(TEXELS, filter="nearest")
    np.testing.assert_array_equal(square.render().array, TEXELS / 255)
    square.materials["white"].texture = glint.Texture(TEXELS[::-1, :, ::-1], filter="nearest")
    np.testing.assert_array_equal(square.render().array, TEXELS[::-1, :, ::-1] / 255)


def test_changes_between_pictures_show(square):
    material = square.materials["white"]
    texture = glint.Texture(TEXELS, filter="nearest", encoding="linear")
    assert (square.render().array == 1).all() and len(square.textures) == 0

    def check(expected):
        image = square.render()
        np.testing.assert_array_equal(image.array, np.float32(expected))
        assert square.copy().render() == image
        assert glint.loads(square.to_glint()).render() == image

    material.texture = texture
    check(TEXELS / 255)
    assert len(square.textures) == 1 and material.texture is texture and square.textures[0] is texture
    texture.uv_map = ((1, 0, 0.5), (0, 1, 0))
    check(TEXELS[:, ::-1] / 255)
    texture.uv_map = ((1, 0, 0), (0, 1, 0))
    texture.image = 255 - texture.image
    check((255 - TEXELS) / 255)
    material.texture = glint.Texture(np.full((1, 1, 3), 51, np.uint16), encoding="linear")
    check(np.full((2, 2, 3), 51 / 65535))
    assert len(square.textures) == 2
    square.textures[1].image = TEXELS[:1, :1]
    check(np.broadcast_to((1, 0, 0), (2, 2, 3)))
    material.texture = texture
    check((255 - TEXELS) / 255)
    material.texture = None
    check(np.ones((2, 2, 3)))
    texture.mapping, texture.world_from_texture = "planar", np.diag([2, 2, 1, 1.0])
    texture.world_from_texture += [(0, 0, 0, -1), (0, 0, 0, -1), (0, 0, 0, 0)]
    square.materials["white"].texture = texture
    check((255 - TEXELS) / 255)
    texture.world_from_texture = None
    np.testing.assert_array_equal(texture.world_from_texture, np.eye(4)[:3])


def test_one_texture_in_two_scenes(square):
    texture = glint.Texture(TEXELS, filter="nearest")
    other = square.copy()
    other.add(glint.Texture(TEXELS[:1], name="first"))
    square.materials[0].texture = other.materials[0].texture = texture
    assert square.render() == other.render()
    assert len(square.textures) == 1 and len(other.textures) == 2 and other.textures[1] is texture
    texture.image = TEXELS[:, ::-1]
    assert square.render() == other.render()
    np.testing.assert_array_equal(other.render().array, TEXELS[:, ::-1] / 255)
    assert square != other
    del other.shapes[0]
    other.spheres(np.zeros((1, 3)), colors=(1, 0, 0), material=square.materials[0])
    assert other.materials[-1].texture is texture


def test_images_from_files(tmp_path, monkeypatch):
    (tmp_path / "pictures").mkdir()
    path = tmp_path / "pictures" / "tiles.ppm"
    path.write_bytes(PPM)
    for image in (path, str(path), PPM):
        np.testing.assert_array_equal(glint.Texture(image).image, TEXELS)
    assert glint.Texture(path).file == str(path) and glint.Texture(PPM).file == ""
    monkeypatch.chdir(tmp_path)
    scene = made_of_arrays()
    picture = scene.render()
    scene.textures["tiles"].image = "pictures/tiles.ppm"
    assert 'file = "pictures/tiles.ppm"' in scene.to_glint()
    (tmp_path / "other").mkdir()
    glint.convert(scene, "other/scene.glint")
    read = glint.load("other/scene.glint")
    assert read.render() == scene.render() == picture
    glint.convert(read, "again.glint")
    assert glint.load("again.glint").textures["tiles"].file == "pictures/tiles.ppm"
    pickled = pickle.dumps(read)
    path.unlink()
    again = pickle.loads(pickled)
    assert again.render() == picture and again.textures["tiles"].file == "" and again == read
    read.textures["tiles"].file = ""
    assert glint.loads(read.to_glint()).render() == picture
    with pytest.raises(FileNotFoundError):
        glint.Texture(path)
    with pytest.raises(glint.GlintError):
        glint.Texture(PPM[:-1])
    path.write_bytes(b"no picture")
    with pytest.raises(glint.GlintError, match="tiles.ppm"):
        glint.Texture(path)


def test_images_are_read_only_and_kept():
    texture = glint.Texture(TEXELS)
    image = texture.image
    assert not image.flags.writeable
    texture.image = TEXELS[:1]
    np.testing.assert_array_equal(image, TEXELS)
    swapped = np.array([[(1, 2, 3)]], ">u2")
    np.testing.assert_array_equal(glint.Texture(swapped).image, swapped)
    mine = TEXELS.copy()
    texture = glint.Texture(mine)
    mine[:] = 0
    np.testing.assert_array_equal(texture.image, TEXELS)


@pytest.mark.parametrize(
    "image, error, message",
    [
        (np.zeros((2, 2), np.uint8), ValueError, "height x width x 3 or 4, found 2 x 2"),
        (np.zeros((2, 2, 2), np.uint8), ValueError, "found 2 x 2 x 2"),
        (np.zeros((0, 2, 3), np.uint8), ValueError, "image: expected 1 to 32768 texels a side, found 0 x 2 x 3"),
        (np.zeros((1, 32769, 3), np.uint8), ValueError, "found 1 x 32769 x 3"),
        (np.zeros((2, 2, 3)), TypeError, "image: expected an array of uint8 or uint16.* found an array of float64"),
        (np.zeros((2, 2, 3), np.int8), TypeError, "found an array of int8"),
        (np.zeros((2, 2, 3), np.uint32), TypeError, "found an array of uint32"),
        (None, TypeError, "found None"),
    ],
)
def test_refuses_images(image, error, message):
    with pytest.raises(error, match=message):
        glint.Texture(image)
    texture = glint.Texture(TEXELS)
    with pytest.raises(error, match=message):
        texture.image = image
    np.testing.assert_array_equal(texture.image, TEXELS)


def test_refuses_values():
    texture = glint.Texture(TEXELS)
    for name, value, message in (
        ("wrap_u", "tile", "wrap_u: expected one of repeat, mirror, clamp, once, clip, found 'tile'"),
        ("mapping", 1, "mapping: expected one of uv, planar, spherical, cylindrical, checker, onion, rings, boxes, slabs, leopard, bricks, hexagons, noise, granite, wrinkles, spiral, mandelbrot, found 1"),
        ("alpha_cutoff", 2, "alpha_cutoff: expected a number from 0 to 1, found 2"),
        ("uv_map", (1, 2), "uv_map: expected two rows of three numbers"),
        ("uv_map", ((1, 0, np.nan), (0, 1, 0)), "uv_map: expected a number from -1e12 to 1e12, found nan"),
        ("world_from_texture", np.eye(3), "world_from_texture: expected a matrix of 3x4 or 4x4 numbers"),
    ):
        with pytest.raises(ValueError, match=message):
            setattr(texture, name, value)
        with pytest.raises(ValueError, match=message):
            glint.Texture(TEXELS, **{name: value})
    with pytest.raises(TypeError, match="did you mean .wrap_u."):
        glint.Texture(TEXELS, wrapu="clamp")
    for wrong in (0, "tiles", TEXELS):
        with pytest.raises(TypeError, match="texture: expected a Texture or None"):
            glint.Material().texture = wrong
        with pytest.raises(TypeError, match="texture: expected a Texture or None"):
            glint.Material(texture=wrong)


def test_a_texture_without_an_inverse_is_refused(square):
    square.materials[0].texture = glint.Texture(TEXELS, mapping="planar", world_from_texture=np.zeros((3, 4)))
    with pytest.raises(glint.GlintError, match="it has no inverse"):
        square.render()


def test_equality_and_copies():
    material = glint.Material(texture=glint.Texture(TEXELS, name="tiles"))
    twin, deep = copy.copy(material), copy.deepcopy(material)
    assert twin == material == deep and twin.texture is material.texture and deep.texture is not material.texture
    deep.texture.image = TEXELS[:1]
    assert deep != material and twin == material
    assert glint.Material() != material != glint.Material(texture=glint.Texture(TEXELS))
    assert glint.Texture(TEXELS) == glint.Texture(TEXELS.copy()) != glint.Texture(TEXELS, wrap_v="once")
    ball = copy.deepcopy(glint.Sphere((0, 0, 0), material=material))
    assert ball.material == material and ball.material.texture is not material.texture
    scene = made_of_arrays()
    other = pickle.loads(pickle.dumps(scene))
    assert other == scene and scene.copy() == scene
    other.textures[0].filter = "bilinear"
    assert other != scene


def test_texture_coordinates_of_meshes():
    mesh = glint.Mesh(CORNERS, FACES, texture_coordinates=UV)
    np.testing.assert_array_equal(mesh.texture_coordinates, UV)
    assert mesh.texture_coordinates.dtype == np.float32 and not mesh.texture_coordinates.flags.writeable
    assert glint.Mesh(CORNERS, FACES).texture_coordinates is None
    np.testing.assert_array_equal(glint.loads(TEXT).shapes[0].texture_coordinates, UV)
    assert mesh != glint.Mesh(CORNERS, FACES)
    for wrong, message in (
        (UV[:3], "texture_coordinates: expected 4, one for each vertex, found 3"),
        (CORNERS, "texture_coordinates: expected an array of N x 2 numbers, found 2 dimensions, 3 columns"),
        (np.where(UV == 1, np.inf, UV), "texture_coordinates: row 1: expected a number from -1e12 to 1e12, found inf"),
    ):
        with pytest.raises(ValueError, match=message):
            glint.Mesh(CORNERS, FACES, texture_coordinates=wrong)


def test_maps_of_colors():
    board = glint.Texture(color_map=[(0, "white"), (0.5, (0, 0, 0.5), 0.25)], mapping="checker", filter="nearest", name="board")
    assert board.color_map == [(0.0, (1, 1, 1)), (0.5, (0, 0, 0.5), 0.25)] and board.image is None
    assert eval(repr(board), {"Texture": glint.Texture}) == board == pickle.loads(pickle.dumps(board))
    assert board != glint.Texture(color_map=[(0, "white")], mapping="checker", filter="nearest", name="board")
    board.color_map = [(0, "#ffffff"), (0.5, "black")]
    scene = glint.Scene(size=(8, 8), background="red")
    scene.add(glint.Plane((0, 0, -0.5), (0, 0, 1), material=glint.Material(color=1, ambient=1, diffuse=0, texture=board)))
    scene.add(glint.Light("ambient"))
    scene.camera.projection, scene.camera.width = "orthographic", 8
    scene.camera.position, scene.camera.look_at = (0, 0, 5), (0, 0, 0)
    picture = scene.render().array
    x, y = np.meshgrid(np.arange(8), np.arange(8))
    np.testing.assert_array_equal(picture[:, :, 0], (x + y + picture[0, 0, 0]) % 2)
    assert glint.loads(scene.to_glint(), name="a.glint").textures[0].color_map == [(0.0, (1, 1, 1)), (0.5, (0, 0, 0))]
    board.image = TEXELS
    assert board.color_map is None


def test_maps_of_colors_are_refused():
    for value, message in (
        ([(0.5, "white"), (0, "black")], "color_map: expected places in ascending order, found 0 after 0.5"),
        (["white", "black"], "color_map: color 1: expected .place, color. or .place, color, alpha., found 'white'"),
        ([(2, "white")], "color_map: color 1: place: expected a number from 0 to 1, found 2"),
        ([], "color_map: expected colors, as the texture has no image"),
    ):
        with pytest.raises(ValueError, match=message):
            glint.Texture(color_map=value)
    for arguments in ({}, {"image": TEXELS, "color_map": [(0, 1)]}):
        with pytest.raises(TypeError, match="expected an image or a color_map"):
            glint.Texture(**arguments)


def test_the_background_has_a_map_of_colors():
    scene = glint.Scene(size=(4, 64))
    scene.add(glint.Sphere((0, 0, 9), 1))
    scene.add(glint.Light("ambient"))
    scene.camera.position, scene.camera.look_at = (0, 0, 0), (0, 0, -1)
    scene.gradient = glint.BackgroundGradient(bottom=-1, top=1, color_map=[(0, "red"), (0.5, "white"), (1, "blue")])
    assert eval(repr(scene.gradient), {"BackgroundGradient": glint.BackgroundGradient}) == scene.gradient
    assert pickle.loads(pickle.dumps(scene.gradient)) == scene.gradient == copy.copy(scene.gradient)
    before = scene.render().array
    scene.gradient.color_map = [(0, "red"), (0.5, "lime"), (1, "blue")]
    after = scene.render().array
    assert (before != after).any() and after[:, :, 1].max() > 0.9 > 0.5 > after[:, :, 0].min()
    with pytest.raises(ValueError, match="color_map: expected places in ascending order"):
        scene.gradient.color_map = [(1, "red"), (0, "blue")]


def test_layers():
    base = glint.Texture(color_map=[(0, (0, 0, 1))], mapping="planar", name="base")
    top = glint.Texture(color_map=[(0, (1, 0, 0), 0.25)], mapping="planar", over=base, name="top")
    scene = glint.Scene()
    scene.add(glint.Sphere((0, 0, 0), 1, material=glint.Material(texture=top)))
    scene.add(glint.Light())
    assert len(scene.textures) == 2
    again = glint.loads(scene.to_glint())
    assert again.shapes[0].material.texture == top
    assert again.shapes[0].material.texture.over == base
    assert copy.deepcopy(top).over is not base
    with pytest.raises(ValueError, match="circle"):
        base.over = top
    with pytest.raises(TypeError, match="over: expected a Texture"):
        top.over = 3
    top.over = None
    assert glint.loads(scene.to_glint()).shapes[0].material.texture.over is None
