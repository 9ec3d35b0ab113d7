# SPDX-License-Identifier: Apache-2.0
"""The zip with the command and the Python package, in a Blender of its own: without GLINT and without glint in PATH, F12 gives a
picture."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import bpy
import package
from io_glint import command

GLINT = os.environ["GLINT"]
SCRIPT = pathlib.Path(__file__).resolve().parent.parent / "try_zip.py"


class ZipWithProgram(unittest.TestCase):
    def test_it_is_installed_and_renders(self):
        platform = next((key for key, patterns in package.PROGRAM.items()
                         if command.own_program() and command.own_program().endswith(os.path.normpath(patterns[0]))), None)
        if platform is None:
            self.skipTest("no zip is for this machine")
        with tempfile.TemporaryDirectory(prefix="glint-test-") as folder:
            program = pathlib.Path(folder, "unpacked", package.PROGRAM[platform][0])
            program.parent.mkdir(parents=True)
            shutil.copy(GLINT, program)
            zip_path = package.make(folder, platform, f"{folder}/unpacked", os.environ["GLINT_TEST_MODULES"])
            environment = dict(os.environ, BLENDER_USER_SCRIPTS=f"{folder}/scripts", BLENDER_USER_CONFIG=f"{folder}/config")
            run = subprocess.run([bpy.app.binary_path, "-b", "--factory-startup", "--python-exit-code", "3", "--python", SCRIPT,
                                  "--", zip_path, f"{folder}/picture.png"],
                                 env=environment, capture_output=True, text=True, timeout=300, check=False)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            self.assertIn("of the zip has drawn", run.stdout)
