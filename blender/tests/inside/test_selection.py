# SPDX-License-Identifier: Apache-2.0
"""Selected Objects: the selected shapes and lights, what selected objects instance, and always a camera."""
import os

import bpy
from support import SceneTest


class Selection(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.key, self.fill = self.lamp(name="Key light"), self.lamp(name="Fill light", location=(-2, -3, 5))
        self.ball = self.add("uv_sphere", name="ball", smooth=True)
        self.other = self.add("uv_sphere", name="other sphere", smooth=True, location=(3, 0, 0))

    def select(self, *objects):
        for ob in self.scene.objects:
            ob.select_set(ob in objects)

    def test_shapes_and_lights(self):
        self.select(self.ball, self.fill)
        for evaluation in ("RENDER", "VIEWPORT"):
            text = self.export(use_selection=True, evaluation=evaluation)
            for name, is_there in (("ball", True), ("other sphere", False), ("Fill light", True), ("Key light", False)):
                self.assertEqual(f'"{name}"' in text, is_there, name)
            self.assertIn("camera {", text)
            self.assertEqual(self.warnings, [])
        self.assertIn('"other sphere"', self.export())
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"))

    def test_a_scene_without_a_selected_light_says_so(self):
        self.select(self.ball)
        self.assertNotIn("light {", self.export(use_selection=True))
        self.assertEqual(self.warnings, ["scene 'Scene': no light is selected, so none is exported"])
        self.assertEqual(self.export_rt2(use_selection=True)["lights"], [])

    def test_nothing_is_selected(self):
        self.select()
        for operator, name in ((bpy.ops.export_scene.glint, "a.glint"), (bpy.ops.export_scene.rt2, "a.json")):
            with self.assertRaisesRegex(RuntimeError, "No object is selected"):
                operator(filepath=self.path(name), use_selection=True)
        self.assertEqual(os.listdir(self.folder), [])

    def test_instances_are_those_of_the_selected_object(self):
        shared = bpy.data.collections.new("shared")
        shared.objects.link(self.ball)
        holders = [self.link(bpy.data.objects.new(name, None)) for name in ("first", "second")]
        for x, holder in enumerate(holders):
            holder.instance_type, holder.instance_collection, holder.location.x = "COLLECTION", shared, 5 * x
        self.select(holders[1])
        text = self.export(use_selection=True)
        self.assertEqual([name in text for name in ('"second/ball"', '"first/ball"', '"ball"')], [True, False, False])
        self.select(self.ball)
        text = self.export(use_selection=True)
        self.assertEqual([name in text for name in ('"second/ball"', '"first/ball"', '"ball"')], [False, False, True])

    def test_curves_and_hidden_objects(self):
        bpy.ops.curve.primitive_bezier_circle_add()
        curve = bpy.context.object
        curve.data.dimensions = "2D"
        curve.data.bevel_depth = 0.1
        self.other.hide_render = True
        self.select(curve, self.other)
        text = self.export(use_selection=True)
        self.assertIn(f'"{curve.name}"', text)
        self.assertNotIn('"ball"', text)
        self.assertNotIn('"other sphere"', text)

    def test_rt2(self):
        self.select(self.other, self.key)
        found = self.export_rt2(use_selection=True)
        self.assertEqual([s["center"] for s in found["spheres"]], [[3, 0, 0]])
        self.assertEqual([light["position"] for light in found["lights"]], [[2, -3, 5]])
        self.assertIn("fov", found["camera"])

    def test_rt2_of_a_collection_names_only_what_is_selected(self):
        custom = bpy.data.collections.new("scene_custom")
        self.scene.collection.children.link(custom)
        for ob in (self.ball, self.key):
            custom.objects.link(ob)
        self.select(self.ball, self.other, self.key)
        from io_glint.export.report import Report
        from io_glint.export_files import export_text, selection_of
        report = Report()
        options = self.scene.glint.options(selection=selection_of(bpy.context))
        export_text(bpy.context, options, "RENDER", True, report)
        self.assertEqual(report.warnings, ["object 'other sphere': left out: it is not in the collection 'scene_custom' (M moves it "
                                           "there)"])

    def test_an_animation(self):
        self.scene.frame_start, self.scene.frame_end = 1, 2
        for frame, x in ((1, 0), (2, 2)):
            self.ball.location.x = x
            self.ball.keyframe_insert("location", frame=frame)
        self.select(self.ball, self.key)
        bpy.ops.export_scene.glint(filepath=self.path("a.glint"), animation=True, use_selection=True)
        for frame in (1, 2):
            with open(self.path(f"a.{frame:04d}.glint"), encoding="utf-8") as file:
                text = file.read()
            self.assertIn('sphere "ball"', text)
            self.assertNotIn("other sphere", text)
