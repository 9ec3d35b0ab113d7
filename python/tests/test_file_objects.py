# SPDX-License-Identifier: Apache-2.0
"""Scenes from objects with read()."""

import io
from types import SimpleNamespace

import pytest

import glint
from conftest import ROOT

CASTLE = ROOT / "scenes" / "epfl" / "castle.json"


def test_file_objects_are_read(tmp_path):
    text = "camera { position = (0, 0, -4) look_at = (0, 0, 0) fov_x = 50 } light { type = ambient }\n"
    text += "sphere { center = (0, 0, 4) radius = 1 }"
    assert glint.load(io.BytesIO(text.encode()), format="glint") == glint.load(io.StringIO(text), format="glint")
    with open(CASTLE, "rb") as file:
        castle = glint.load(file, size=(8, 8))
    assert castle == glint.load(CASTLE, size=(8, 8)) and castle.files == [str(CASTLE)]
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "a.glint").write_text(text)
    (tmp_path / "b.glint").write_text('include "parts/a.glint"')
    with open(tmp_path / "b.glint") as file:
        assert len(glint.load(file).lights) == 1
    # What is no file on a disk reads no file of other folders.
    outside = io.StringIO(f'include "{tmp_path}/parts/a.glint"')
    with pytest.raises(glint.GlintError, match="is outside the folders"):
        glint.load(outside, format="glint")
    outside.seek(0)
    assert len(glint.load(outside, format="glint", include_path=tmp_path / "parts").lights) == 1
    with pytest.raises(glint.GlintError, match="file: error: expected a name that ends in one of .cgfs"):
        glint.load(io.StringIO(text))
    with pytest.raises(glint.GlintError, match="file:1:15: "):
        glint.load(io.StringIO("sphere { oops }"), format="glint")
    with pytest.raises(TypeError, match=r"paths: expected a path or an object with read\(\), found 3"):
        glint.load(3)
    with pytest.raises(TypeError, match="expected bytes or a string, found NoneType"):
        glint.load(SimpleNamespace(read=lambda: None), format="glint")
