# SPDX-License-Identifier: Apache-2.0
"""In Blender's interface, under xvfb: export and F12 as the menus call them, then quit."""
import os
import pathlib
import sys
import traceback
import unittest

import bpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [os.environ["GLINT_TEST_MODULES"], str(HERE), str(HERE / "interface"), str(HERE.parent)]

import counting  # noqa: E402  pylint: disable=wrong-import-position
import package  # noqa: E402  pylint: disable=wrong-import-position


def run():
    try:
        zip_path = package.make(os.environ["GLINT_TEST_FOLDER"])
        sys.path.remove(str(HERE.parent))
        bpy.ops.preferences.addon_install(filepath=str(zip_path), overwrite=True)
        bpy.ops.preferences.addon_enable(module="io_glint")
        suite = unittest.defaultTestLoader.discover(
            HERE / "interface", pattern=f"test_*{os.environ['GLINT_TEST_PATTERN']}*.py", top_level_dir=HERE / "interface")
        counting.write(os.environ["GLINT_TEST_COUNTS"], counting.run(suite))
    except BaseException:  # whatever happens, Blender must not stay open
        traceback.print_exc()
    bpy.ops.wm.quit_blender()


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(run, first_interval=1.0)
