# SPDX-License-Identifier: Apache-2.0
"""F12: the picture of the engine is glint's, also of a border, of every frame, and layer by layer."""
import os
import stat
import time

import bpy
from io_glint import exr
from support import SceneTest


class Engine(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()
        self.world((0.1, 0.1, 0.2))
        self.add("monkey", material=self.material())
        self.add("plane", size=10, location=(0, 0, -1))
        self.scene.render.engine = "GLINT"
        settings = self.scene.render.image_settings
        settings.file_format, settings.color_depth, settings.exr_codec, settings.color_mode = "OPEN_EXR", "32", "ZIP", "RGB"

    def picture(self, name="f12"):
        """F12's picture as glint.exr.Part."""
        self.scene.render.filepath = self.path(f"{name}.exr")
        bpy.ops.render.render(write_still=True)
        return exr.read(self.scene.render.filepath)[0]

    def beauty(self, *more):
        self.export()
        out = self.path("own.exr")
        self.glint("render", self.path("scene.glint"), "-o", out, "-q", *more)
        return exr.read(out)[0]

    def assert_same(self, a, b):
        self.assertEqual((a.width, a.height), (b.width, b.height))
        for channel in "RGB":
            self.assertEqual(a.channels[channel], b.channels[channel])

    def test_f12_is_glints_picture(self):
        self.assert_same(self.picture(), self.beauty())

    def test_border_and_percentage(self):
        render = self.scene.render
        render.resolution_percentage = 150
        render.use_border = render.use_crop_to_border = True
        render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.1, 0.7, 0.3, 0.9
        part = self.picture()
        self.assert_same(part, self.beauty("--crop", f"{part.width}x{part.height}+14+{96 - 86}"))
        render.use_crop_to_border = False
        whole = self.picture("whole")
        self.assertEqual((whole.width, whole.height), (144, 96))
        self.assertEqual(whole.channels["R"][0], 0)
        self.assertEqual(whole.channels["R"][10 * 144 + 14], part.channels["R"][0])

    def test_a_transparent_film(self):
        self.scene.render.film_transparent = True
        self.scene.render.image_settings.color_mode = "RGBA"
        for has_passes in (False, True):
            bpy.context.view_layer.use_pass_z = has_passes
            bpy.context.view_layer.update_render_passes()
            picture, own = self.picture(), self.beauty()
            self.assert_same(picture, own)
            self.assertEqual(picture.channels["A"], own.channels["A"])
            self.assertEqual((min(picture.channels["A"]), max(picture.channels["A"])), (0, 1))
        corner = [picture.channels[c][0] for c in "RGBA"]
        self.assertEqual(corner, [0, 0, 0, 0])

    def test_adaptive_samples(self):
        whole = self.picture()
        self.scene.glint.adaptive = True
        adaptive = self.picture("adaptive")
        self.assert_same(adaptive, self.beauty())
        self.assertNotEqual(whole.channels["R"], adaptive.channels["R"])

    def test_mist_and_the_worlds_light(self):
        self.scene.world.mist_settings.start, self.scene.world.mist_settings.depth = 4, 10
        plain = self.export()
        self.scene.glint.mist = self.scene.glint.occlusion = True
        self.scene.world.mist_settings.falloff = "QUADRATIC"
        text = self.export()
        self.assertIn("fog { type = linear  color = (0.1, 0.1, 0.2)  start = 4  end = 14 }", text)
        self.assertIn("occlusion { samples = 16  color = (0.1, 0.1, 0.2) }", text)
        self.assertEqual([w for w in self.warnings if "mist" in w],
                         [f"world '{self.scene.world.name}': its mist's falloff (quadratic) is taken as linear"])
        self.assertIn("type = ambient", plain)
        self.assertNotIn("type = ambient", text)
        for block in ("fog {", "occlusion {"):
            self.assertNotIn(block, plain)
        self.beauty()

    def test_passes(self):
        layer = bpy.context.view_layer
        layer.use_pass_z = layer.use_pass_normal = layer.glint.shadow = True
        layer.update_render_passes()
        self.scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
        picture = self.picture("passes")
        self.export()
        own = self.layers("depth", "normal", "shadow")
        prefix = f"{layer.name}."
        names = {name.removeprefix(prefix) for name in picture.channels}
        self.assertLessEqual({"Depth.Z", "Normal.X", "glint shadow.X"}, names)
        for theirs, part, ours in (("Depth.Z", "depth", "Z"), ("Normal.X", "normal", "X"), ("Normal.Z", "normal", "Z")):
            a, b = picture.channels[prefix + theirs], own[part].channels[ours]
            self.assertEqual(list(a), [min(v, 1e10) for v in b], theirs)
        beauty = self.beauty()
        for channel in "RGB":
            self.assertEqual(picture.channels[f"{prefix}Combined.{channel}"], beauty.channels[channel])

    def test_an_animation_of_24_frames(self):
        ball = self.add("ico_sphere", name="ball", subdivisions=2)
        self.scene.frame_start, self.scene.frame_end = 1, 24
        for frame, x in ((1, -2), (24, 2)):
            ball.location.x = x
            ball.keyframe_insert("location", frame=frame)
        self.scene.render.image_settings.file_format = "PNG"
        self.scene.render.image_settings.color_depth = "8"
        self.scene.render.filepath = self.path("frame_")
        bpy.ops.render.render(animation=True)
        files = [self.path(f"frame_{f:04d}.png") for f in range(1, 25)]
        contents = {open(file, "rb").read() for file in files}
        self.assertEqual(len(contents), 24)

    def fake(self, script):
        path = self.path("fake")
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + script)
        os.chmod(path, stat.S_IRWXU)
        preferences = bpy.context.preferences.addons["io_glint"].preferences
        preferences.glint_path = path
        self.addCleanup(setattr, preferences, "glint_path", "")
        return path

    def test_without_glint_there_is_a_clear_message(self):
        preferences = bpy.context.preferences.addons["io_glint"].preferences
        preferences.glint_path = "/nowhere/glint"
        self.addCleanup(setattr, preferences, "glint_path", "")
        with self.assertRaisesRegex(RuntimeError, "The glint command was not found"):
            bpy.ops.render.render()
        with self.assertRaisesRegex(RuntimeError, "The glint command was not found"):
            bpy.ops.glint.find()

    def test_an_error_of_glint_is_passed_on(self):
        self.fake('echo "scene.glint:3:4: error: expected a number" >&2\nexit 2\n')
        with self.assertRaisesRegex(RuntimeError, "expected a number"):
            bpy.ops.render.render()

    def test_success_without_a_picture_is_an_error(self):
        self.fake("exit 0\n")
        with self.assertRaisesRegex(RuntimeError, "picture.exr"):
            bpy.ops.render.render()

    def test_a_flood_of_messages_blocks_nothing(self):
        real = os.environ["GLINT"]
        self.fake(f'i=0; while [ $i -lt 5000 ]; do echo "line $i of a flood of messages that fills the pipe" >&2; i=$((i+1)); done\n'
                  f'exec "{real}" "$@"\n')
        self.assert_same(self.picture(), self.beauty())

    def test_the_user_stops_it(self):
        from io_glint import engine
        self.fake(f'echo $$ > {self.path("pid")}\nexec sleep 60\n')
        is_stopped = engine.GlintRenderEngine._is_stopped
        engine.GlintRenderEngine._is_stopped = lambda _: os.path.exists(self.path("pid"))
        self.addCleanup(setattr, engine.GlintRenderEngine, "_is_stopped", is_stopped)
        start = time.monotonic()
        bpy.ops.render.render()
        self.assertLess(time.monotonic() - start, 20)
        with open(self.path("pid"), encoding="utf-8") as file, self.assertRaises(ProcessLookupError):
            os.kill(int(file.read()), 0)

    def test_find_glint(self):
        self.assertEqual(bpy.ops.glint.find(), {"FINISHED"})

    def test_no_camera(self):
        self.scene.camera = None
        with self.assertRaises(RuntimeError):
            bpy.ops.render.render()

    def test_the_empty_scene(self):
        for ob in list(self.scene.objects):
            if ob.type != "CAMERA":
                bpy.data.objects.remove(ob)
        part = self.picture()
        self.assertAlmostEqual(part.channels["B"][0], 0.2, places=6)
