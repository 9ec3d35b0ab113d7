# SPDX-License-Identifier: Apache-2.0
"""The code of docs/python.md runs, and its types are right; so do the notebooks."""

import json
import os
import re
import subprocess
import sys

import pytest

from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "examples" / "notebooks").glob("*.ipynb"))


def code_of_document() -> str:
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    return "\n".join(re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))


@pytest.mark.filterwarnings("ignore::glint.GlintWarning")
def test_code_of_the_document_runs(tmp_path, monkeypatch):
    (tmp_path / "scenes").symlink_to(ROOT / "scenes")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("webbrowser.open", lambda address: True)
    exec(compile(code_of_document(), "docs/python.md", "exec"), {})
    assert (tmp_path / "ball.png").stat().st_size > 1000


def mypy(*arguments, cwd):
    return subprocess.run(
        [sys.executable, "-m", *arguments], cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )


def test_types_of_the_document(tmp_path):
    (tmp_path / "program.py").write_text(code_of_document(), encoding="utf-8")
    checked = mypy("mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), "program.py", cwd=tmp_path)
    assert checked.returncode == 0, checked.stdout


PLANTED = [
    'scene.render(shading="lambert")',
    'glint.load("a.json", shading="lambert")',
    'glint.Light("sun")',
    'glint.Light("point").kind = "sun"',
    'glint.Camera(projection="fisheye")',
    'glint.Camera((0, 0, 5))',
    'glint.Texture("a.png", wrap_u="tile")',
    'glint.Sphere((0, 0, 0), 1, material="gold")',
    'glint.Material(colr=(1, 0, 0))',
    'scene.backgroud = (0, 0, 0)',
    'scene.lights.append(glint.Camera())',
    'scene.render(size="large", aa=1.5)',
    'scene.render().save("a.png", transfer="gamma")',
    'scene.fog = glint.Fog("dense")',
    'scene.cast((0, 0, 5))',
    'scene.camera.zoom("near")',
    'scene.turntable("3")',
    'glint.surface([0])',
    'glint.show(scene, up="z")',
    'glint.explain(scene, 3)',
]


def test_planted_errors_are_found(tmp_path):
    lines = ["import glint", "scene = glint.Scene()", *PLANTED]
    (tmp_path / "program.py").write_text("\n".join(lines), encoding="utf-8")
    checked = mypy("mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), "program.py", cwd=tmp_path)
    found = {int(number) for number in re.findall(r"^program.py:(\d+): error", checked.stdout, re.MULTILINE)}
    assert found == set(range(3, 3 + len(PLANTED))), checked.stdout


def test_stubs_are_those_of_the_module(tmp_path):
    """So each row of the tables of fields has its line in the stubs."""
    allowed = tmp_path / "allowed"
    allowed.write_text(r"glint\._glint\._.*")  # types that only the stub has
    checked = mypy(
        "mypy.stubtest", "glint._glint", "--concise", "--allowlist", str(allowed), "--ignore-unused-allowlist",
        cwd=tmp_path,
    )  # fmt: skip
    # What pybind11 does itself: a metaclass, and an __init__ of classes without one.
    own = re.compile(r"metaclass differs$|(Diagnosed|Diagnostic|Shape)\.__init__ is inconsistent")
    faults = [line for line in checked.stdout.splitlines() if not own.search(line)]
    assert not faults, "\n".join(faults)
    assert "metaclass differs" in checked.stdout  # it did run


def test_types_of_the_package():
    package = ROOT / "python" / "glint"
    checked = mypy("mypy", "--strict", "--cache-dir", os.devnull, str(package), cwd=ROOT)
    assert checked.returncode == 0, checked.stdout


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks_run(path, tmp_path):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    notebook = nbformat.read(path, as_version=4)
    environment = {"JUPYTER_PLATFORM_DIRS": "1", "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    os.environ.update(environment)
    # The kernel of the Python that runs the tests, whichever is installed.
    notebook.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    nbclient.NotebookClient(
        notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(path.parent)}}
    ).execute()
    pictures = [o for cell in notebook.cells for o in cell.get("outputs", []) if "image/png" in o.get("data", {})]
    assert pictures, "a notebook ends in a picture"


def test_there_are_nine_notebooks():
    assert len(NOTEBOOKS) == 9


def test_the_printed_line_is_the_one_that_is_tested():
    line = "/usr/bin/python3 -m venv --system-site-packages v && v/bin/pip install --no-build-isolation ./python"
    for document in ("README.md", "docs/python.md"):
        assert f"    {line}\n" in (ROOT / document).read_text(encoding="utf-8")
    run = (ROOT / "python" / "tests" / "run").read_text(encoding="utf-8")
    assert "/usr/bin/python3 -m venv --system-site-packages" in run
    assert "pip\" install --no-build-isolation" in run


def test_jupyter_finds_the_environment(tmp_path):
    """The kernel that docs/python.md installs runs the Python that has the package, without help by variables."""
    pytest.importorskip("ipykernel")
    arguments = ["-m", "ipykernel", "install", "--user", "--name", "glint"]
    guide = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    assert f"    v/bin/python {' '.join(arguments)}\n" in guide
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    environment.update(JUPYTER_DATA_DIR=str(tmp_path), JUPYTER_PLATFORM_DIRS="1")
    subprocess.run([sys.executable, *arguments], env=environment, check=True, capture_output=True)
    kernel = json.loads((tmp_path / "kernels" / "glint" / "kernel.json").read_text(encoding="utf-8"))
    imported = subprocess.run(
        [kernel["argv"][0], "-c", "import glint, ipykernel; print(glint.__file__)"],
        env=environment, cwd=tmp_path, capture_output=True, text=True, check=True,
    )
    assert "glint" in imported.stdout
