# SPDX-License-Identifier: Apache-2.0
"""F12 with a folder that keeps the scene, and with more arguments of the command."""
import os

import bpy
from io_glint import exr
from support import SceneTest


class RenderSettings(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()
        self.monkey = self.add("monkey", material=self.material())
        self.modifier = self.monkey.modifiers.new("subdivision", "SUBSURF")
        self.use_engine()

    def rendered(self, scene, *more):
        self.glint("render", scene, "-o", self.path("own.exr"), "-q", *more)
        return exr.read(self.path("own.exr"))[0]

    def assert_same(self, a, b):
        for channel in "RGB":
            self.assertEqual(a.channels[channel], b.channels[channel])

    def kept(self):
        return sorted(name for name in os.listdir(self.path("kept")) if name != "meshes")

    def test_the_scene_is_kept(self):
        self.scene.glint.keep_folder = self.path("kept")
        self.modifier.render_levels = 2
        picture = self.picture()
        self.assertEqual(self.kept(), ["Scene.0001.glint"])
        self.assertEqual([name[-4:] for name in os.listdir(self.path("kept/meshes"))], [".ply"])
        self.assert_same(picture, self.rendered(self.path("kept/Scene.0001.glint")))

    def test_each_frame_is_kept(self):
        self.scene.glint.keep_folder = self.path("kept/")
        self.scene.frame_start, self.scene.frame_end = 9, 10
        self.scene.render.filepath = self.path("frame_")
        bpy.ops.render.render(animation=True)
        self.assertEqual(self.kept(), ["Scene.0009.glint", "Scene.0010.glint"])

    def test_the_homeworks_scene_is_kept(self):
        self.scene.glint.keep_folder, self.scene.glint.picture = self.path("kept"), "RT2"
        self.picture()
        self.assertEqual(self.kept(), ["Scene.0001.json"])

    def test_after_a_failure_the_message_names_the_kept_scene(self):
        self.scene.glint.keep_folder, self.scene.glint.extra_arguments = self.path("kept"), "--bogus"
        with self.assertRaisesRegex(RuntimeError, "unknown option '--bogus'.* The scene is kept in (.*)") as caught:
            bpy.ops.render.render()
        self.assertIn(self.path("kept/Scene.0001.glint"), str(caught.exception))

    def test_a_folder_that_cannot_be_made(self):
        with open(self.path("file"), "w", encoding="utf-8"):
            pass
        self.scene.glint.keep_folder = self.path("file")
        with self.assertRaisesRegex(RuntimeError, "file"):
            bpy.ops.render.render()

    def test_arguments_are_passed_on(self):
        before = self.picture()
        self.scene.glint.extra_arguments = "--no-shadows --shading 'phong'"
        picture = self.picture()
        self.export()
        self.assert_same(picture, self.rendered(self.path("scene.glint"), "--no-shadows", "--shading", "phong"))
        self.assertNotEqual(picture.channels["R"], before.channels["R"])

    def test_arguments_that_are_refused(self):
        for text, message in (("--output a.png", "--output cannot be given"), ("'", "Extra arguments: No closing quotation"),
                              ("--size 10", "--size"), ("-h", "picture.exr")):
            self.scene.glint.extra_arguments = text
            with self.assertRaisesRegex(RuntimeError, message):
                bpy.ops.render.render()
        self.assertFalse(os.path.exists("a.png"))

    def test_another_size_is_an_error(self):
        self.scene.glint.extra_arguments = "--size 10x10"
        with self.assertRaisesRegex(RuntimeError, "--size cannot be given: the picture is Blender's"):
            bpy.ops.render.render()
