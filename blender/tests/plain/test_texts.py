# SPDX-License-Identifier: Apache-2.0
"""The text of .glint files, the frames of cameras, the maps of RT2, and files."""
import math
import os
import tempfile
import types
import unittest

from io_glint.export import camera, rt2, text
from io_glint.export.files import write_text
from io_glint.export.shapes import Shape


class Text(unittest.TestCase):
    def test_numbers(self):
        for value, expected in ((0.0, "0"), (-0.0, "0"), (0.1, "0.1"), (1e-9, "1e-09"), (-2.5, "-2.5"), (1e20, "1e+20")):
            self.assertEqual(text.number(value), expected)

    def test_strings(self):
        self.assertEqual(text.string('a"b\\c\nd\te\x01'), '"a\\"b\\\\c\\nd\\te\\u0001"')
        self.assertEqual(text.string("Ünï ☃"), '"Ünï ☃"')
        self.assertEqual(text.string("\ud800"), '"\ufffd"')

    def test_comments_have_one_line(self):
        self.assertNotIn("\n", text.comment("a\nb } light { }"))

    def test_blocks(self):
        self.assertEqual(text.block("sphere", "a", [("radius", "1")]), 'sphere "a" { radius = 1 }')
        self.assertEqual(text.block("camera", None, []), "camera {  }")

    def test_unique_names(self):
        names = text.UniqueNames()
        self.assertEqual([names.name(k, "a") for k in (1, 2, 1, 3)], ["a", "a 2", "a", "a 3"])


def view(**changes):
    values = dict(name="c", position=(0.0, 0.0, 0.0), right=(1.0, 0.0, 0.0), up=(0.0, 1.0, 0.0), forward=(0.0, 0.0, -1.0),
                  is_perspective=True, left=-1.0, right_edge=1.0, bottom=-0.5, top=0.5, size=(200, 100))
    return camera.View(**(values | changes))


class Camera(unittest.TestCase):
    def test_centred(self):
        block = camera.camera_block(view())
        self.assertIn("fov_x = 90", block)
        self.assertIn("look_at = (0, 0, -10)", block)

    def test_shifted(self):
        block = camera.camera_block(view(left=-0.5, right_edge=1.5))
        self.assertIn("right = (2, 0, 0)  up = (0, 1, 0)  forward = (0.5, 0, -1)", block)

    def test_oblong_pixels(self):
        self.assertIn("right = (2, 0, 0)  up = (0, 1, 0)  forward = (0, 0, -1)", camera.camera_block(view(size=(100, 100))))

    def test_orthographic(self):
        block = camera.camera_block(view(is_perspective=False, left=0.0, right_edge=2.0))
        self.assertIn("position = (1, 0, 0)", block)
        self.assertIn("width = 2", block)

    def render(self, **values):
        defaults = dict(resolution_x=480, resolution_y=270, resolution_percentage=100, use_border=True, border_min_x=0.0,
                        border_max_x=1.0, border_min_y=0.0, border_max_y=1.0)
        return types.SimpleNamespace(**(defaults | values))

    def test_border(self):
        self.assertIsNone(camera.border(self.render()))
        self.assertIsNone(camera.border(self.render(use_border=False, border_max_x=0.5)))
        self.assertEqual(camera.border(self.render(border_min_x=0.25, border_max_y=0.5)), (360, 135, 120, 135))
        # 0.7 is a little less in single precision; its product with 480, rounded to single precision, is 336.
        self.assertEqual(camera.border(self.render(border_max_x=0.699999988079071))[0], 336)

    def test_percentage(self):
        self.assertEqual(camera.picture_size(self.render(resolution_percentage=33)), (158, 89))
        self.assertEqual(camera.picture_size(self.render(resolution_x=4, resolution_percentage=1)), (1, 2))


UNIT = ((1.0, 0, 0, 0), (0, 1.0, 0, 0), (0, 0, 1.0, 0))


class RT2(unittest.TestCase):
    def test_names(self):
        for name, word in (("Sphere.001", "sphere"), ("my PLANE", "plane"), ("a cylinder", "cylinder"), ("Cube", None),
                           ("plane sphere", "sphere")):
            self.assertEqual(rt2.type_by_name(name), word)

    def test_a_sphere_needs_an_even_scale(self):
        ball = Shape("sphere", (("center", (1.0, 0, 0)), ("radius", 2.0)))
        mirrored = ((-0.5, 0, 0, 1.0), (0, 0.5, 0, 0), (0, 0, 0.5, 0))
        self.assertEqual(rt2.world_shape(ball, mirrored), ("spheres", {"center": (0.5, 0, 0), "radius": 1}))
        self.assertIsNone(rt2.world_shape(ball, ((1.0, 0, 0, 0), (0, 2.0, 0, 0), (0, 0, 1.0, 0))))

    def test_a_cylinder_needs_round_and_right_ends(self):
        shape = Shape("cylinder", (("from", (0.0, 0, -1)), ("to", (0.0, 0, 1)), ("radius", 1.0), ("caps", False)))
        name, entry = rt2.world_shape(shape, ((2.0, 0, 0, 0), (0, 2.0, 0, 0), (0, 0, 3.0, 5.0)))
        self.assertEqual((name, entry["radius"], entry["height"], entry["center"]), ("cylinders", 2, 6, (0, 0, 5)))
        self.assertIsNone(rt2.world_shape(shape, ((2.0, 0, 0, 0), (0, 1.0, 0, 0), (0, 0, 1.0, 0))))
        self.assertIsNone(rt2.world_shape(shape, ((1.0, 0, 0.5, 0), (0, 1.0, 0, 0), (0, 0, 1.0, 0))))

    def test_the_normal_of_a_plane_under_an_uneven_scale(self):
        plane = Shape("plane", (("point", (0.0, 0, 0)), ("normal", (math.sqrt(0.5), 0, math.sqrt(0.5)))))
        _, entry = rt2.world_shape(plane, ((2.0, 0, 0, 0), (0, 1.0, 0, 0), (0, 0, 1.0, 0)))
        self.assertAlmostEqual(entry["normal"][2] / entry["normal"][0], 2)

    def test_boxes_cannot_be_said(self):
        self.assertIsNone(rt2.world_shape(Shape("box", (("min", (0, 0, 0)), ("max", (1, 1, 1)))), UNIT))


class Files(unittest.TestCase):
    def test_completely_or_not_at_all(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.glint")
            write_text(path, "one\n")
            os.chmod(path, 0o640)
            write_text(path, "two ☃\n")
            with open(path, encoding="utf-8") as file:
                self.assertEqual(file.read(), "two ☃\n")
            self.assertEqual(os.stat(path).st_mode & 0o777, 0o640)
            with self.assertRaises(OSError):
                write_text(os.path.join(folder, "no", "b.glint"), "x")
            self.assertEqual(os.listdir(folder), ["a.glint"])
