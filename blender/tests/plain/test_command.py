# SPDX-License-Identifier: Apache-2.0
"""The glint command: found, run, watched and stopped; its OpenEXR files read."""
import math
import os
import platform
import stat
import sys
import tempfile
import time
import types
import unittest
from unittest import mock

from io_glint import command, exr, passes
from io_glint.export import camera

GLINT = os.environ.get("GLINT") or os.path.join(os.path.dirname(__file__), "../../../build/release/glint")
SCENE = """
conventions { epsilon = 0.001 }
camera { position = (0, 0, 8)  look_at = (0, 0, 0) }
light { position = (2, 4, 5) }
sphere { center = (0, 0, 0)  radius = 1  mirror = 0.9 }
sphere { center = (2, 0, 0)  radius = 1  mirror = 0.9 }
"""


class Find(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def script(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + text)
        os.chmod(path, stat.S_IRWXU)
        return path

    def test_preference_then_path_then_variable(self):
        other = self.script("other", "echo glint 9.9\n")
        with mock.patch.dict(os.environ, PATH=self.folder, GLINT=other):
            self.assertEqual(command.find(), other)
            in_path = self.script("glint", "echo glint 1\n")
            self.assertEqual(command.find(), in_path)
            self.assertEqual(command.find(other), other)
            self.assertIsNone(command.find("/nowhere/glint"))
        with mock.patch.dict(os.environ, PATH="/nowhere", GLINT=self.folder):
            self.assertIsNone(command.find())

    def own_program(self, mode, text="echo glint 9.9\n"):
        """Puts a program where the add-on's zip has it."""
        path = self.script("own", text)
        os.chmod(path, mode)
        for mocked in (mock.patch.dict(command.PROGRAMS, {(sys.platform, platform.machine().lower()): path}),
                       mock.patch.dict(os.environ, PATH=self.folder, GLINT="")):
            mocked.start()
            self.addCleanup(mocked.stop)
        return path

    def test_the_add_ons_own_precedes_path(self):
        own, in_path = self.own_program(0o755), self.script("glint", "echo glint 1\n")
        self.assertEqual(command.find(), own)
        self.assertEqual(command.find(in_path), in_path)
        os.unlink(own)
        self.assertEqual(command.find(), in_path)

    def test_the_add_ons_own_is_made_executable(self):
        own = self.own_program(0o640)
        self.assertEqual(command.find(), own)
        self.assertEqual(stat.S_IMODE(os.stat(own).st_mode), 0o750)
        self.assertEqual(command.version(own), "glint 9.9")

    def test_the_add_ons_own_may_not_be_made_executable(self):
        own = self.own_program(0o644)
        with mock.patch.object(os, "chmod", side_effect=PermissionError):
            self.assertIsNone(command.find())
            self.assertEqual(command.not_found_text(""), f"The glint command of the add-on, {own}, cannot be run: this file may "
                             "not be made executable")
        in_path = self.script("glint", "echo glint 1\n")
        with mock.patch.object(os, "chmod", side_effect=PermissionError):
            self.assertEqual(command.find(), in_path)

    def test_a_machine_that_no_zip_is_for(self):
        self.own_program(0o755)
        with mock.patch.object(platform, "machine", return_value="riscv64"):
            self.assertIsNone(command.own_program())
            self.assertIsNone(command.find())
            self.assertEqual(command.not_found_text(""), command.NOT_FOUND)

    def test_messages_are_for_users_of_blender(self):
        for text in (command.NOT_FOUND, command.not_found_text("/nowhere")):
            self.assertNotIn("make ", text)

    def test_version(self):
        self.assertEqual(command.version(self.script("a", "echo glint 9.9\n")), "glint 9.9")
        for text in ("echo something else\n", "exit 3\n"):
            with self.assertRaises(OSError):
                command.version(self.script("b", text))

    def test_progress_and_messages(self):
        run = command.Run([self.script("slow", r'printf "\r[##     ]  37%%  0:05 left\033[K" >&2; sleep 0.3;'
                                               r'printf "\r\033[Ka.glint:1:2: warning: w\nx: error: e\n" >&2; exit 4')])
        deadline = time.monotonic() + 5
        while run.progress == 0 and time.monotonic() < deadline:
            run.poll(0.01)
        self.assertAlmostEqual(run.progress, 0.37)
        self.assertEqual(run.poll(5), 4)
        self.assertEqual(run.messages(), ["a.glint:1:2: warning: w", "x: error: e"])
        self.assertEqual(command.diagnostics(run.messages()), (["x: error: e"], ["a.glint:1:2: warning: w"]))

    def test_what_does_not_listen_is_stopped(self):
        run = command.Run([self.script("deaf", "exec sleep 60\n")])
        start = time.monotonic()
        run.stop()
        self.assertLess(time.monotonic() - start, 6)

    def test_what_cannot_be_run(self):
        with self.assertRaises(OSError):
            command.Run(["/nowhere/glint"])


@unittest.skipUnless(os.access(GLINT, os.X_OK), "no glint command")
class Exr(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.scene = os.path.join(folder.name, "a.glint")
        self.out = os.path.join(folder.name, "a.exr")
        with open(self.scene, "w", encoding="utf-8") as file:
            file.write(SCENE)

    def render(self, *more):
        run = command.Run([GLINT, "render", self.scene, "-o", self.out, "-s", "45x37", *more])
        self.assertEqual(run.poll(60), 0, run.messages())
        return {part.name: part for part in exr.read(self.out)}

    def test_parts(self):
        parts = self.render("--aov", "normal,depth,object")
        self.assertEqual(list(parts), ["beauty", "normal", "depth", "object"])
        part = parts["object"]
        self.assertEqual((part.width, part.height, len(part.channels["I"])), (45, 37, 45 * 37))
        self.assertEqual(set(part.channels["I"]), {0, 1, 2})
        for i, hit in enumerate(part.channels["I"]):
            length = sum(parts["normal"].channels[c][i] ** 2 for c in "XYZ")
            self.assertAlmostEqual(length, 1 if hit else 0, places=5)
        depth = passes.pixels(parts["depth"], "depth")
        self.assertEqual(depth[0], (math.inf,))
        self.assertAlmostEqual(min(depth)[0], 7, delta=0.1)
        # Blender's depth is along the view's axis, and finite.
        view = camera.View("", (0, 0, 7), (1, 0, 0), (0, 1, 0), (0, 0, -1), True, -0.5, 0.5, -0.4, 0.4, (45, 37))
        written = types.SimpleNamespace(view=view)
        axial = passes.pixels(passes.converted(parts["depth"], "depth", written, None), "depth")
        self.assertEqual(axial[0], (passes.FAR,))
        longest = view.ray_lengths()[0]
        self.assertAlmostEqual(longest, math.sqrt(1 + (0.5 * 44 / 45) ** 2 + (0.4 * 36 / 37) ** 2))
        self.assertEqual(view.ray_lengths((2, 1, 0, 0)), view.ray_lengths()[:2])

    def test_rows_are_turned_around(self):
        parts = self.render("--aov", "normal")
        pixels = passes.pixels(parts["normal"], "normal")
        top = parts["normal"].channels["Y"]
        self.assertEqual(pixels[-45][1], top[0])

    def test_a_plain_file_and_a_damaged_one(self):
        self.assertEqual(list(self.render()), [""])
        with open(self.out, "rb") as file:
            data = file.read()
        for damaged in (b"", b"no picture at all", data[:60], data[:-200]):
            with open(self.out, "wb") as file:
                file.write(damaged)
            with self.assertRaises(exr.ExrError):
                exr.read(self.out)
