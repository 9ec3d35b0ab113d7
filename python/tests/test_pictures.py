# SPDX-License-Identifier: Apache-2.0
"""Pictures as arrays of bytes, PIL's and file objects."""

import io

import numpy as np
import pytest

import glint


def test_bytes_are_those_of_the_png(scene):
    image = scene.render()
    array = image.to_uint8()
    assert array.dtype == np.uint8 and array.shape == (48, 64, 3) and array.flags.writeable and array.flags.owndata
    read = glint.Image.open(io.BytesIO(image.to_bytes()))
    assert (np.round(read.array * 255) == array).all()
    assert (image.to_uint8(transfer="srgb") != array).any()
    with pytest.raises(ValueError, match="transfer: expected 'none' or 'srgb', found 'gamma'"):
        image.to_uint8(transfer="gamma")


def test_bytes_of_pictures_with_alpha(scene):
    """They are those on a black background, but for the rounding of the edges' bytes."""
    del scene.shapes["floor"]
    scene.background = "white"
    image = scene.render(alpha=True, aa=3)
    array = image.to_uint8()
    assert array.dtype == np.uint8 and array.shape == (48, 64, 3)
    scene.background = "black"
    assert np.abs(array.astype(int) - scene.render(aa=3).to_uint8()).max() <= 1
    inside = image.layers["alpha"][..., 0] == 1
    assert (image.to_uint8(transfer="srgb")[inside] == scene.render(aa=3).to_uint8(transfer="srgb")[inside]).all()
    large = glint.compare(image, image)  # whose HTML shows the bytes
    assert large._repr_html_().count("<img") == 3


def test_pil(scene):
    pytest.importorskip("PIL")
    image = scene.render()
    assert image.to_pil().mode == "RGB" and (np.asarray(image.to_pil()) == image.to_uint8()).all()
    assert scene.render(alpha=True).to_pil().mode == "RGBA"


def test_file_objects(scene, tmp_path):
    image = scene.render()
    for format in ("png", "exr", "ppm"):
        file = io.BytesIO()
        image.save(file, format)
        assert file.getvalue() == image.to_bytes(format)
    file = io.BytesIO()
    image.save(file)
    assert file.getvalue() == image.to_bytes("png")
    with open(tmp_path / "a.ppm", "wb") as named:
        image.save(named)
    assert (tmp_path / "a.ppm").read_bytes() == image.to_bytes("ppm")
    with open(tmp_path / "a.ppm", "rb") as named:
        assert glint.Image.open(named) == glint.Image.open(tmp_path / "a.ppm")
    image.save(tmp_path / "picture", "png")
    assert (tmp_path / "picture").read_bytes() == image.to_bytes("png")
    with pytest.raises(TypeError, match="path: expected a string or a path, found 3"):
        glint.Image.open(3)
