# SPDX-License-Identifier: Apache-2.0
"""Builds the extension module by CMake: in build/python of glint's tree, so that a second build takes seconds, or of the C++
sources that a source distribution has in the folder `source`."""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE / "source"
ROOT = SOURCES if SOURCES.exists() else HERE.parent
#: What a source distribution takes of glint's tree.
PARTS = ["CMakeLists.txt", "cmake", "include", "src", "python/CMakeLists.txt", "python/src", "LICENSE", "NOTICE"]

NEEDS = """glint is built from its C++ sources, which takes some minutes. This needs a C++20 compiler (g++ 12, clang 14 or later),
CMake 3.25, Ninja, pybind11 2.10 and the libraries of the file NOTICE. On Debian 12 they are in these packages:
  g++ cmake ninja-build pkg-config pybind11-dev libhwy-dev libtbb-dev libfmt-dev libfast-float-dev nlohmann-json3-dev libcli11-dev
  libstb-dev zlib1g-dev libpng-dev libjpeg62-turbo-dev libopenexr-dev libfreetype-dev"""


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        print(NEEDS, flush=True)
        missing = [program for program in ("cmake", "ninja") if not shutil.which(program)]
        if missing:
            raise SystemExit(f"missing: {' and '.join(missing)}")
        build = pathlib.Path(os.environ.get("GLINT_BUILD", ROOT / "build" / "python"))
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        # The library and the module alone.
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "Python_EXECUTABLE": sys.executable,
            "GLINT_PYTHON": "ON",
            "GLINT_COMMAND": "OFF",
            "GLINT_TESTS": "OFF",
            "GLINT_INSTALL": "OFF",
            "GLINT_FILES_TOGETHER": "ON",
        }
        if shutil.which("ccache"):
            options["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
        subprocess.check_call(
            ["cmake", "-S", str(ROOT), "-B", str(build), "-G", "Ninja"]
            + [f"-D{key}={value}" for key, value in options.items()]
            + shlex.split(os.environ.get("CMAKE_ARGS", ""))
        )
        subprocess.check_call(["cmake", "--build", str(build), "--target", "glint_python"])
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(build / "python" / "glint" / target.name), str(target))


class SourceDistribution(sdist):
    """Has the C++ sources, too."""

    def make_release_tree(self, base_dir: str, files: list[str]) -> None:
        super().make_release_tree(base_dir, files)
        for part in PARTS:
            source, target = ROOT / part, pathlib.Path(base_dir) / "source" / part
            target.parent.mkdir(parents=True, exist_ok=True)
            if source.is_dir():
                shutil.copytree(source, target)
            else:
                shutil.copy(source, target)


def version() -> str:
    header = (ROOT / "include" / "glint" / "version.h").read_text()
    match = re.search(r'#define GLINT_VERSION "([0-9.]+)"', header)
    assert match
    return match.group(1)


# setuptools takes them from its own folder only.
for licence in ("LICENSE", "NOTICE"):
    shutil.copyfile(ROOT / licence, HERE / licence)
setup(
    version=version(),
    ext_modules=[Extension("glint._glint", [])],
    cmdclass={"build_ext": CMakeBuild, "sdist": SourceDistribution},
)
