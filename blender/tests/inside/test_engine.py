# SPDX-License-Identifier: Apache-2.0
"""F12: the picture of the engine is glint's, also of a border, of every frame, and layer by layer."""
import os
import re
import shutil
import stat
import time
import unittest.mock

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
        self.use_engine()

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
        for theirs, part, ours in (("Normal.X", "normal", "X"), ("Normal.Z", "normal", "Z")):
            a, b = picture.channels[prefix + theirs], own[part].channels[ours]
            self.assertEqual(list(a), list(b), theirs)
        beauty = self.beauty()
        for channel in "RGB":
            self.assertEqual(picture.channels[f"{prefix}Combined.{channel}"], beauty.channels[channel])

    def test_passes_for_compositing(self):
        """Depth along the view's axis, as Cycles', and Blender's pass indices."""
        layer, render = bpy.context.view_layer, self.scene.render
        layer.use_pass_z = layer.use_pass_object_index = layer.use_pass_material_index = True
        self.scene.objects["Suzanne"].pass_index, self.scene.objects["Plane"].pass_index = 7, 3
        bpy.data.materials["paint"].pass_index = 5
        layer.update_render_passes()
        render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
        ours = self.picture("ours")
        render.engine = "CYCLES"
        cycles = self.scene.cycles
        cycles.device, cycles.samples, cycles.use_denoising = "CPU", 1, False
        cycles.pixel_filter_type, cycles.filter_width = "BOX", 0.01
        theirs = self.picture("theirs")
        for name, tolerance in (("Depth.Z", 0.02), ("IndexOB.X", 0), ("IndexMA.X", 0)):
            a, b = (part.channels[f"{layer.name}.{name}"] for part in (ours, theirs))
            self.assertGreater(len({v for v in b if v < 1e9}), 1, name)
            near = [abs(x - y) <= tolerance for x, y in zip(a, b)]
            self.assertLess(near.count(False), 0.03 * len(near), name)  # at edges
        self.assertEqual({*ours.channels[f"{layer.name}.IndexOB.X"]}, {0, 3, 7})

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
            file.write('#!/bin/sh\n[ "$1" = --version ] && { echo glint 9.9; exit; }\n' + script)
        os.chmod(path, stat.S_IRWXU)
        preferences = bpy.context.preferences.addons["io_glint"].preferences
        preferences.glint_path = path
        self.addCleanup(setattr, preferences, "glint_path", "")
        return path

    def test_without_glint_there_is_a_clear_message(self):
        preferences = bpy.context.preferences.addons["io_glint"].preferences
        preferences.glint_path = "/nowhere/glint"
        self.addCleanup(setattr, preferences, "glint_path", "")
        for operator in (bpy.ops.render.render, bpy.ops.glint.find):
            with self.assertRaisesRegex(RuntimeError, "The glint command of the preferences, /nowhere/glint, is no program"):
                operator()
        preferences.glint_path = ""
        with unittest.mock.patch.dict(os.environ, {"GLINT": "", "PATH": "/nowhere"}):
            with self.assertRaisesRegex(RuntimeError, "The glint command was not found. Install the add-on's zip"):
                bpy.ops.render.render()

    def test_an_old_glint_is_named(self):
        path = self.fake("")
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\necho glint 0.2.9\n")
        with self.assertRaisesRegex(RuntimeError, "is glint 0.2.9: this add-on needs version 0.3 or later"):
            bpy.ops.render.render()

    def test_a_crash_is_named_and_the_scene_kept(self):
        self.fake("kill -SEGV $$\n")
        modifier = bpy.context.scene.objects["Suzanne"].modifiers.new("subdivision", "SUBSURF")
        modifier.levels = modifier.render_levels = 2
        with self.assertRaisesRegex(RuntimeError, "signal SIGSEGV. The scene is kept in (.*glint)") as caught:
            bpy.ops.render.render()
        kept = re.search(r"kept in (\S+\.glint)", str(caught.exception))[1]
        self.addCleanup(shutil.rmtree, os.path.dirname(kept))
        with open(kept, encoding="utf-8") as file:
            self.assertIn(".ply", file.read())
        # It can be rendered, with its meshes.
        self.glint("render", kept, "-o", self.path("kept.png"))

    def test_messages_do_not_name_the_temporary_folder(self):
        self.fake('echo "$2:3:4: error: expected a number" >&2\nexit 2\n')
        with self.assertRaisesRegex(RuntimeError, "glint: scene.glint:3:4: error: expected a number"):
            bpy.ops.render.render()

    def test_the_number_of_threads(self):
        self.fake(f'echo "$@" > {self.path("arguments")}\nexit 0\n')
        self.scene.render.threads_mode, self.scene.render.threads = "FIXED", 3
        with self.assertRaises(RuntimeError):
            bpy.ops.render.render()
        with open(self.path("arguments"), encoding="utf-8") as file:
            self.assertIn("--threads 3", file.read())

    def test_the_user_stops_the_export(self):
        from io_glint import engine
        self.fake(f'echo run > {self.path("run")}\n')
        is_stopped, asked = engine.GlintRenderEngine._is_stopped, []
        engine.GlintRenderEngine._is_stopped = lambda _: asked.append(1) or len(asked) > 1
        self.addCleanup(setattr, engine.GlintRenderEngine, "_is_stopped", is_stopped)
        bpy.ops.render.render()
        self.assertEqual(len(asked), 2)
        self.assertFalse(os.path.exists(self.path("run")))

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
