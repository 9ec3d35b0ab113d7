# SPDX-License-Identifier: Apache-2.0
"""Pictures in windows, and in the cells of a notebook."""

import os
import pathlib
import re
import sys
import tempfile
import webbrowser
from urllib.parse import unquote, urlparse

import pytest

import glint


@pytest.fixture
def opened(tmp_path, monkeypatch):
    """The addresses that were opened, by a browser that does nothing."""
    addresses = []

    def open_address(address):
        addresses.append(address)
        return True

    folder = tmp_path / "a folder"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    monkeypatch.setattr(webbrowser, "open", open_address)
    monkeypatch.setattr(sys, "platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"):
        monkeypatch.delenv(name, raising=False)
    return addresses


@pytest.mark.parametrize("name", ["DISPLAY", "WAYLAND_DISPLAY", "BROWSER"])
def test_a_window(scene, opened, monkeypatch, name):
    monkeypatch.setenv(name, ":0")
    image = scene.show(size=(20, 10), shading="phong")
    assert image == scene.render(size=(20, 10), shading="phong")
    (address,) = opened
    path = pathlib.Path(unquote(urlparse(address).path))
    assert path.suffix == ".png" and (glint.Image.open(path).to_uint8() == image.to_uint8()).all()
    image.show()
    assert len(set(opened)) == 2


@pytest.mark.parametrize("platform", ["win32", "darwin"])
def test_systems_that_always_have_a_display(scene, opened, monkeypatch, platform):
    image = scene.render()
    monkeypatch.setattr(sys, "platform", platform)
    image.show()
    assert len(opened) == 1


def refuse(address):
    raise webbrowser.Error("could not locate runnable browser")


@pytest.mark.parametrize(
    "display, browser, message",
    [
        ("", None, "there is no display to show the picture on"),
        (":0", lambda address: False, "no program could be started to show the picture"),
        (":0", refuse, r"no program could be started to show the picture \(could not locate runnable browser\)"),
    ],
)
def test_without_a_display_the_file_is_named(scene, opened, monkeypatch, display, browser, message):
    if display:
        monkeypatch.setenv("DISPLAY", display)
        monkeypatch.setattr(webbrowser, "open", browser)
    with pytest.warns(glint.GlintWarning, match=f"{message}; it is in the file ") as caught:
        image = scene.show()
    assert opened == [] and caught[0].filename == __file__
    path = re.search("in the file (.*)$", str(caught[0].message))[1]
    assert os.path.dirname(path) == tempfile.tempdir
    assert (glint.Image.open(path).to_uint8() == image.to_uint8()).all()


def test_a_notebook_shows_a_picture_once():
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    cells = (
        "import glint\nscene = glint.Scene(glint.Sphere(), glint.Light('point', position=(3, 4, 5)), size=(20, 10))",
        "scene.show()",
        "image = scene.show()\nimage.show()",
        "image",
        "scene",
        "glint.explain(scene, 10, 5)",
    )
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in cells])
    notebook.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    os.environ.update(JUPYTER_PLATFORM_DIRS="1", PYTHONPATH=os.pathsep.join(p for p in sys.path if p))
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    outputs = [[sorted(output["data"]) for output in cell.outputs] for cell in notebook.cells]
    picture = ["image/png", "text/plain"]
    assert outputs[1:4] == [[picture, ["text/plain"]], [picture, picture], [picture]]
    assert outputs[4] == [["image/png", "text/html", "text/plain"]] and outputs[5] == [["text/html", "text/plain"]]
    assert notebook.cells[4].outputs[0]["data"]["image/png"].startswith("iVBOR")
