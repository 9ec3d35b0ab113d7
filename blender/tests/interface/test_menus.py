# SPDX-License-Identifier: Apache-2.0
"""Export and F12 with the interface open; the panels can be drawn."""
import os
import tempfile
import unittest
import unittest.mock

import bpy


class Interface(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="glint-test-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.window = bpy.context.window_manager.windows[0]
        area = next(a for a in self.window.screen.areas if a.type == "VIEW_3D")
        region = next(r for r in area.regions if r.type == "WINDOW")
        self.override = {"window": self.window, "area": area, "region": region}
        bpy.context.scene.render.resolution_x, bpy.context.scene.render.resolution_y = 96, 64

    def test_export_and_f12(self):
        with bpy.context.temp_override(**self.override):
            self.assertFalse(bpy.app.background)
            for operator, name in ((bpy.ops.export_scene.glint, "a.glint"), (bpy.ops.export_scene.rt2, "a.json")):
                path = os.path.join(self.folder, name)
                self.assertEqual(operator(filepath=path), {"FINISHED"})
                self.assertGreater(os.path.getsize(path), 100)
            scene = bpy.context.scene
            scene.render.engine = "GLINT"
            scene.render.filepath = os.path.join(self.folder, "f12.png")
            bpy.ops.render.render(write_still=True)
            self.assertGreater(os.path.getsize(scene.render.filepath), 100)

    def test_panels_are_drawn(self):
        bpy.context.scene.render.engine = "GLINT"
        area = next(a for a in self.window.screen.areas if a.type == "PROPERTIES")
        for context in ("RENDER", "VIEW_LAYER", "OBJECT", "MATERIAL", "DATA", "WORLD"):
            with self.subTest(context=context), bpy.context.temp_override(window=self.window, area=area):
                area.spaces[0].context = context
                area.tag_redraw()
                self.assertEqual(bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1), {"FINISHED"})

    def test_the_panels_of_a_light(self):
        """Each setting once, and the shadow."""
        scene = bpy.context.scene
        scene.render.engine = "GLINT"
        lamp = next(ob for ob in scene.objects if ob.type == "LIGHT")
        self.addCleanup(setattr, bpy.context.view_layer.objects, "active", bpy.context.view_layer.objects.active)
        bpy.context.view_layer.objects.active = lamp
        old, lamp.data.type = lamp.data.type, "AREA"
        self.addCleanup(setattr, lamp.data, "type", old)
        self.assertNotIn("GLINT", bpy.types.DATA_PT_area.COMPAT_ENGINES)  # Eevee's panel has the area's shape
        self.assertIn("GLINT", bpy.types.DATA_PT_EEVEE_light.COMPAT_ENGINES)
        area = next(a for a in self.window.screen.areas if a.type == "PROPERTIES")
        drawn, real = [], bpy.types.DATA_PT_glint_light.draw
        with unittest.mock.patch.object(bpy.types.DATA_PT_glint_light, "draw", lambda panel, c: (real(panel, c), drawn.append(c.light))), \
                bpy.context.temp_override(window=self.window, area=area):
            area.spaces[0].context = "DATA"
            area.tag_redraw()
            bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
        self.assertIn(lamp.data, drawn)

    def test_the_panel_of_warnings(self):
        from io_glint import warnings_panel
        scene = bpy.context.scene
        scene.render.engine = "GLINT"
        scene.objects["Cube"].visible_shadow = False
        self.addCleanup(setattr, scene.objects["Cube"], "visible_shadow", True)
        with bpy.context.temp_override(**self.override):
            bpy.ops.render.render()
            self.assertEqual([item for item, _ in warnings_panel.kept()], ["object 'Cube'"])
            bpy.ops.glint.copy_warnings()
            self.assertIn("object 'Cube': its 'Shadow Visibility' is ignored", bpy.context.window_manager.clipboard)
        area = next(a for a in self.window.screen.areas if a.type == "PROPERTIES")
        with bpy.context.temp_override(window=self.window, area=area):
            area.spaces[0].context = "RENDER"
            area.tag_redraw()
            self.assertEqual(bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1), {"FINISHED"})

    def test_menus_have_the_exports(self):
        self.assertIn("EXPORT_SCENE_OT_glint", dir(bpy.types))
        self.assertIn("EXPORT_SCENE_OT_rt2", dir(bpy.types))
