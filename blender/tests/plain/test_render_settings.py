# SPDX-License-Identifier: Apache-2.0
"""What F12's settings say: arguments as a shell splits them, without those that write files, and names of kept scenes."""
import os
import types
import unittest
from unittest import mock

from io_glint.render_settings import ArgumentsError, extra_arguments, kept_name


class RenderSettings(unittest.TestCase):
    def test_arguments(self):
        for text, expected in (("", []), ("  ", []), ("--seed 3 --no-shadows", ["--seed", "3", "--no-shadows"]),
                               ("--convention 'a=b c' \"x y\" # q", ["--convention", "a=b c", "x y", "#", "q"]),
                               ("--shading=phong;x -q", ["--shading=phong;x", "-q"])):
            self.assertEqual(extra_arguments(text), expected)

    def test_backslashes_of_windows(self):
        with mock.patch.object(os, "name", "nt"):
            self.assertEqual(extra_arguments(r'C:\lights.glint "D:\a b.glint"'), ["C:\\lights.glint", "D:\\a b.glint"])

    def test_what_is_refused(self):
        for text in ("-o a.png", "-oa.png", "-qo a.png", "--output a.png", "--output=a.png", "--stats a.json", "--stats=a.json",
                     "-s 2x2", "-qs2x2", "--size=2x2", "--crop 2x2+0+0", "--part 1/2", "--resume", "--aov normal", "'unfinished"):
            with self.assertRaisesRegex(ArgumentsError, "^Extra arguments: "):
                extra_arguments(text)

    def test_names(self):
        layers = [types.SimpleNamespace(name="A/B"), types.SimpleNamespace(name="C")]
        for name, count, frame, expected in (("Scene", 1, 1, "Scene.0001"), ("a/../b c", 1, 12345, "a_.._b_c.12345"),
                                             ("Ünï.001", 2, 7, "Ünï.001.A_B.0007")):
            scene = types.SimpleNamespace(name=name, view_layers=layers[:count], frame_current=frame)
            self.assertEqual(kept_name(scene, layers[0]), expected)
