# SPDX-License-Identifier: Apache-2.0
"""Cameras: rays through pixels are Blender's, whatever the projection, the sensor and the picture."""
import math

import bpy
from io_glint import exr
from support import SceneTest


class Camera(SceneTest):
    def setUp(self):
        super().setUp()
        self.lamp()
        self.add("plane", size=14)
        self.add("monkey", location=(0, 0, 1), scale=(1.4, 1.4, 1.4))
        self.add("cube", location=(-2, 1, 1), rotation=(0.3, 0.2, 0.5))

    def test_sensor_fits(self):
        for fit in ("AUTO", "HORIZONTAL", "VERTICAL"):
            for size in ((96, 64), (64, 96)):
                with self.subTest(fit=fit, size=size):
                    self.camera(sensor_fit=fit, sensor_width=36, sensor_height=20, lens=28)
                    self.scene.render.resolution_x, self.scene.render.resolution_y = size
                    self.check_hits()

    def test_shift(self):
        self.camera(shift_x=0.2, shift_y=-0.13)
        self.check_hits()
        self.assertIn("forward =", self.export())

    def test_pixel_aspect_and_percentage(self):
        self.camera()
        render = self.scene.render
        render.pixel_aspect_x, render.pixel_aspect_y, render.resolution_percentage = 1.0, 1.6, 73
        self.check_hits(step=3)
        self.assertIn("size = 70 x 46", self.export())

    def test_orthographic(self):
        self.camera(type="ORTHO", ortho_scale=7)
        self.check_hits()
        self.scene.camera.data.shift_x = 0.15
        self.check_hits()
        self.scene.render.pixel_aspect_x = 1.5
        self.check_hits()

    def test_scale_and_parents_of_the_camera(self):
        camera = self.camera()
        parent = self.link(bpy.data.objects.new("rig", None))
        parent.scale, parent.rotation_euler = (2, 2, 2), (0, 0, 0.4)
        camera.parent = parent
        camera.location = camera.location / 2
        camera.scale = (3, 3, 3)
        self.check_hits()

    def cycles_points(self):
        """The points that Cycles hits, by pixel; (0, 0, 0) is a miss."""
        render, layer = self.scene.render, bpy.context.view_layer
        render.engine, layer.use_pass_position = "CYCLES", True
        cycles = self.scene.cycles
        cycles.device, cycles.samples, cycles.use_denoising, cycles.pixel_filter_type = "CPU", 1, False, "BOX"
        cycles.filter_width = 0.01
        settings = render.image_settings
        settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR_MULTILAYER", "32", "ZIP"
        render.filepath = self.path("cycles.exr")
        bpy.ops.render.render(write_still=True)
        part = exr.read(render.filepath)[0]
        return list(zip(*(part.channels[f"{layer.name}.Position.{c}"] for c in "XYZ")))

    def check_points(self):
        self.export()
        part = self.layers("position")["position"]
        ours, theirs = zip(*(part.channels[c] for c in "XYZ")), self.cycles_points()
        near = [math.dist(a, b) < 0.05 for a, b in zip(ours, theirs)]
        self.assertGreater(sum(any(p) for p in theirs), 500)
        self.assertLess(near.count(False), 0.02 * len(near))  # at edges

    def test_a_parent_whose_scale_shears_the_camera(self):
        parent = self.link(bpy.data.objects.new("rig", None))
        parent.scale = (1, 2, 0.7)
        for settings in ({}, {"shift_x": 0.1}, {"type": "ORTHO", "ortho_scale": 8}):
            with self.subTest(**settings):
                camera = self.camera(location=(3, -4, 5), **settings)
                camera.rotation_euler.z += 0.3
                camera.parent = parent
                bpy.context.view_layer.update()
                self.check_hits()
                self.check_points()

    def test_a_mirrored_camera(self):
        camera = self.camera()
        camera.scale.x = -1
        bpy.context.view_layer.update()
        self.check_points()

    def test_no_camera(self):
        self.scene.camera = None
        for operator in (bpy.ops.export_scene.glint, bpy.ops.export_scene.rt2):
            with self.assertRaisesRegex(RuntimeError, "no camera"):
                operator(filepath=self.path("none.glint"))

    def test_what_is_no_camera_or_not_glints(self):
        self.scene.camera = self.add("cube", name="not one")
        with self.assertRaisesRegex(RuntimeError, "'not one' is not a camera"):
            self.export()
        self.camera(type="PANO")
        with self.assertRaisesRegex(RuntimeError, "PANO"):
            self.export()

    def test_without_extent_or_finite_numbers(self):
        for scale, location, settings, words in (((0, 0, 0), (0, 0, 9), {}, "no extent"),
                                                 ((1, 1, 1), (0, 0, float("nan")), {}, "not finite"),
                                                 ((1, 1, 1), (0, 0, 9), {"type": "ORTHO", "ortho_scale": 0.0}, "no extent")):
            camera = self.camera(**settings)
            camera.scale, camera.location = scale, location
            for export in (self.export, self.export_rt2):
                with self.assertRaisesRegex(RuntimeError, words):
                    export()

    def test_what_is_ignored_is_named(self):
        camera = self.camera().data
        camera.dof.use_dof = True
        render = self.scene.render
        render.use_motion_blur = render.use_border = True
        render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.25, 0.5, 0.25, 0.75
        self.export()
        for word in ("depth of field", "motion blur", "--crop 24x32+24+16"):
            self.assertEqual(sum(word in w for w in self.warnings), 1, self.warnings)

    def test_clipping_is_named(self):
        self.camera(clip_start=0.1, clip_end=100)
        self.export()
        self.assertEqual(self.warnings, [])
        for clip in ({"clip_start": 8.5, "clip_end": 100}, {"clip_start": 0.1, "clip_end": 8.5}):
            self.camera(**clip)
            self.export()
            self.assertEqual(sum("'Suzanne'" in w and "clipping" in w for w in self.warnings), 1, self.warnings)
