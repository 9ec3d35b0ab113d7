# SPDX-License-Identifier: Apache-2.0
"""Builds the extension module by CMake, in build/python of glint's tree, so that a second build takes seconds."""

import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent.parent


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
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
        subprocess.check_call(
            ["cmake", "-S", str(ROOT), "-B", str(build), "-G", "Ninja"]
            + [f"-D{key}={value}" for key, value in options.items()]
            + shlex.split(os.environ.get("CMAKE_ARGS", ""))
        )
        subprocess.check_call(["cmake", "--build", str(build), "--target", "glint_python"])
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(build / "python" / "glint" / target.name), str(target))


def version() -> str:
    header = (ROOT / "include" / "glint" / "version.h").read_text()
    match = re.search(r'#define GLINT_VERSION "([0-9.]+)"', header)
    assert match
    return match.group(1)


setup(version=version(), ext_modules=[Extension("glint._glint", [])], cmdclass={"build_ext": CMakeBuild})
