# SPDX-License-Identifier: Apache-2.0
"""The programs of docs/python_gallery.md are short, run, and make the pictures beside them.

GLINT_UPDATE_GOLDEN=1 writes the pictures again."""

import os
import re
import shutil

import numpy as np
import pytest

from conftest import ROOT

DOCUMENT = (ROOT / "docs" / "python_gallery.md").read_text(encoding="utf-8")
PROGRAMS = re.findall(r"^```python\n(.*?)^```\n\n!\[[^]]+\]\(python_gallery/(\w+\.png)\)$", DOCUMENT, re.MULTILINE | re.DOTALL)
KEPT = ROOT / "docs" / "python_gallery"


def frames(path):
    """The bytes of all pixels; files of other versions of zlib differ."""
    images = pytest.importorskip("PIL.Image")
    with images.open(path) as image:
        found = []
        for number in range(getattr(image, "n_frames", 1)):
            image.seek(number)
            found.append(np.asarray(image.convert("RGB")))
        return np.array(found)


@pytest.mark.parametrize("program, name", PROGRAMS, ids=[name[:-4] for _, name in PROGRAMS])
def test_programs_make_their_pictures(program, name, tmp_path, monkeypatch, capsys):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scenes").symlink_to(ROOT / "scenes")
    try:
        exec(compile(program, name, "exec"), {})
    finally:
        pyplot.close("all")
    if os.environ.get("GLINT_UPDATE_GOLDEN"):
        KEPT.mkdir(exist_ok=True)
        shutil.copy(name, KEPT / name)
    made, kept = frames(name), frames(KEPT / name)
    assert made.shape == kept.shape
    assert np.array_equal(made, kept), f"{np.count_nonzero((made != kept).any(axis=-1))} pixels differ"


def test_programs_have_ten_lines():
    assert len(PROGRAMS) == DOCUMENT.count("```python") >= 10
    for program, name in PROGRAMS:
        lines = program.splitlines()
        assert len(lines) <= 10 and max(map(len, lines)) <= 130, name


def test_pictures_are_small_and_used():
    files = sorted(path.name for path in KEPT.iterdir())
    assert files == sorted(name for _, name in PROGRAMS)
    assert sum(path.stat().st_size for path in KEPT.iterdir()) < 600_000
