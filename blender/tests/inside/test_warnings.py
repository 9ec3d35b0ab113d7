# SPDX-License-Identifier: Apache-2.0
"""The panel "glint: warnings": what it keeps, and the objects that it selects."""
import bpy
from io_glint import warnings_panel
from support import SceneTest


class Warnings(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()
        self.balls = [self.add("cube", name=name) for name in ("Ball", "a/b", "it's")]

    def test_the_last_render_or_export_is_kept(self):
        self.balls[0].visible_shadow = False
        self.export()
        self.assertEqual([": ".join(one) for one in warnings_panel.kept()], self.warnings)
        self.assertEqual([item for item, _ in warnings_panel.kept()], ["object 'Ball'"])
        self.balls[0].visible_shadow, self.balls[1].visible_glossy = True, False
        self.scene.render.engine = "GLINT"
        bpy.ops.render.render()
        self.assertEqual([item for item, _ in warnings_panel.kept()], ["object 'a/b'"])

    def test_items_that_are_objects(self):
        objects = bpy.context.view_layer.objects
        for item, name in (("object 'Ball'", "Ball"), ("object 'Ball/inner'", "Ball"), ("object 'a/b'", "a/b"),
                           ("object 'it's'", "it's"), ("camera 'Camera'", "Camera"), ("light 'gone'", None),
                           ("material 'Ball'", None), ("glint", None)):
            self.assertEqual(warnings_panel.object_name(item, objects), name, item)

    def test_select(self):
        for name in ("Ball", "a/b"):
            self.assertEqual(bpy.ops.glint.select_item(name=name), {"FINISHED"})
            self.assertEqual([ob.name for ob in bpy.context.selected_objects], [name])
            self.assertEqual(bpy.context.object.name, name)
        with self.assertRaisesRegex(RuntimeError, "no object 'gone'"):
            bpy.ops.glint.select_item(name="gone")
