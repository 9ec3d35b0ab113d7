# SPDX-License-Identifier: Apache-2.0
"""Inside `blender -b`: installs the add-on from its zip, as a user would, and runs the tests of tests/inside."""
import os
import pathlib
import sys
import unittest

import bpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [os.environ["GLINT_TEST_MODULES"], str(HERE), str(HERE / "inside"), str(HERE.parent)]

import counting  # noqa: E402  pylint: disable=wrong-import-position
import package  # noqa: E402  pylint: disable=wrong-import-position

zip_path = package.make(os.environ["GLINT_TEST_FOLDER"])
sys.path.remove(str(HERE.parent))  # the add-on is that of the zip
bpy.ops.preferences.addon_install(filepath=str(zip_path), overwrite=True)
bpy.ops.preferences.addon_enable(module="io_glint")

suite = unittest.defaultTestLoader.discover(HERE / "inside", pattern=f"test_*{os.environ['GLINT_TEST_PATTERN']}*.py",
                                            top_level_dir=HERE / "inside")
counting.write(os.environ["GLINT_TEST_COUNTS"], counting.run(suite))
