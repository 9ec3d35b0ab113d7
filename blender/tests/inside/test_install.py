# SPDX-License-Identifier: Apache-2.0
"""The add-on from its zip: enabled, disabled and enabled again, it leaves nothing behind."""
import pathlib
import unittest.mock
import urllib.parse

import io_glint
import bpy
from io_glint import preferences
from support import SceneTest


class Install(SceneTest):
    def test_it_is_the_one_of_the_zip(self):
        self.assertIn("scripts/addons/io_glint", io_glint.__file__)

    def test_the_documentation_of_the_zip_is_shown(self):
        with unittest.mock.patch("webbrowser.open") as show:
            self.assertEqual(bpy.ops.glint.documentation(), {"FINISHED"})
        (url,) = show.call_args[0]
        path = pathlib.Path(urllib.parse.unquote(urllib.parse.urlparse(url).path))
        self.assertIn("<h1", path.read_text(encoding="utf-8"))
        with unittest.mock.patch.object(preferences, "DOCUMENTATION", "/nowhere"), self.assertRaisesRegex(RuntimeError, "zip"):
            bpy.ops.glint.documentation()

    def test_the_interface_has_what_is_read(self):
        """Panels for settings that Blender shows for its own engines only."""
        for name in ("WORLD_PT_glint_mist", "DATA_PT_EEVEE_light", "VIEWLAYER_PT_glint_override", "DATA_PT_glint_light"):
            self.assertIn("GLINT", getattr(bpy.types, name).COMPAT_ENGINES, name)

    def traces(self):
        return [hasattr(bpy.types, "EXPORT_SCENE_OT_rt2"), hasattr(bpy.types.Scene, "glint"),
                hasattr(bpy.types.Object, "glint_shape"), hasattr(bpy.types.ViewLayer, "glint"),
                any("GLINT" in getattr(p, "COMPAT_ENGINES", ()) for p in bpy.types.Panel.__subclasses__()
                    if p.__module__.startswith("bl_ui")),
                bpy.types.RenderEngine.bl_rna_get_subclass_py("GLINT") is not None]

    def test_disabled_and_enabled_again(self):
        for _ in range(2):
            self.assertEqual(self.traces(), [True] * 6)
            bpy.ops.preferences.addon_disable(module="io_glint")
            try:
                self.assertEqual(self.traces(), [False] * 6)
            finally:
                bpy.ops.preferences.addon_enable(module="io_glint")
        self.camera()
        self.assertIn("camera {", self.export())
