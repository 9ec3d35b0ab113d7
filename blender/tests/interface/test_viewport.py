# SPDX-License-Identifier: Apache-2.0
"""Rendered mode: the viewport shows what F12 shows, follows edits, and comes soon."""
import os
import statistics
import sys
import tempfile
import time
import unittest
import unittest.mock
import weakref

import bpy
from mathutils import Quaternion

SECONDS = 20  # a picture that is not there by then does not come


class RenderedMode(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="glint-test-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.window = bpy.context.window_manager.windows[0]
        self.area = next(a for a in self.window.screen.areas if a.type == "VIEW_3D")
        self.region = next(r for r in self.area.regions if r.type == "WINDOW")
        self.space = self.area.spaces[0]
        self.scene = bpy.context.scene
        self.scene.render.engine = "GLINT"
        self.scene.glint.aa = 1
        self.scene.view_settings.view_transform = "Standard"
        for name in ("show_region_header", "show_region_tool_header", "show_region_toolbar", "show_region_hud", "show_gizmo"):
            setattr(self.space, name, False)
        self.space.overlay.show_overlays = False
        self.space.shading.type = "RENDERED"
        self.space.region_3d.view_perspective = "CAMERA"

    def tearDown(self):
        self.space.shading.type = "SOLID"
        self.redraw()

    def redraw(self):
        with bpy.context.temp_override(window=self.window, area=self.area, region=self.region):
            bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)

    def viewport(self):
        from io_glint.viewport import viewports  # it needs a window  pylint: disable=import-outside-toplevel
        (found,) = viewports()
        return found

    def wait(self):
        """Draws until the picture is final, as Blender's timer does."""
        self.redraw()
        viewport, end = self.viewport(), time.monotonic() + SECONDS
        while not viewport.renderer.is_final and time.monotonic() < end:
            viewport.renderer.step()
        self.assertEqual(viewport.renderer.fault, "")
        self.assertTrue(viewport.renderer.is_final)
        viewport._is_changed = True  # pylint: disable=protected-access
        self.redraw()

    def screenshot(self):
        """The viewport's pixels: width, height, and bytes as floats."""
        path = os.path.join(self.folder, "viewport.png")
        with bpy.context.temp_override(window=self.window, area=self.area, region=self.region):
            bpy.ops.screen.screenshot_area(filepath=path)
        return self.pixels(path)

    @staticmethod
    def pixels(path):
        image = bpy.data.images.load(path)
        image.colorspace_settings.name = "Non-Color"
        try:
            return *image.size, list(image.pixels)
        finally:
            bpy.data.images.remove(image)

    def difference(self, one, other):
        self.assertEqual(one[:2], other[:2])
        return statistics.fmean(abs(a - b) for a, b in zip(one[2], other[2]))

    def test_the_renderers_picture_is_shown(self):
        """With Blender's view transform, in its place: (0, 0) is the corner at the bottom left."""
        self.space.region_3d.view_perspective, self.space.region_3d.view_distance = "PERSP", 6
        self.wait()
        width, height, shown = self.screenshot()
        picture = self.viewport().renderer.picture
        self.assertEqual(picture.shape[:2], (height, width))
        values = []
        for y in range(20, height - 40, 25):
            for x in range(20, width - 40, 25):
                for channel in range(3):
                    value = min(1.0, float(picture[y, x, channel]))
                    values.append(value)
                    curve = 12.92 * value if value < 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
                    self.assertAlmostEqual(shown[4 * (y * width + x) + channel], curve, delta=0.01, msg=f"{x}, {y}")
        self.assertGreater(max(values) - min(values), 0.2)

    def test_edits_are_followed(self):
        self.wait()
        before = self.screenshot()
        loads = self.viewport().renderer.loads
        lamp = next(ob for ob in self.scene.objects if ob.type == "LIGHT")
        old = lamp.data.energy
        lamp.data.energy = 20 * old
        self.wait()
        brighter = self.screenshot()
        self.assertGreater(self.difference(before, brighter), 0.003)
        self.assertEqual(self.viewport().renderer.loads, loads)  # no shape was read again
        lamp.data.energy = old
        self.wait()
        self.assertLess(self.difference(before, self.screenshot()), 1e-3)
        cube = next(ob for ob in self.scene.objects if ob.type == "MESH")
        cube.location.x += 2
        self.wait()
        self.assertGreater(self.difference(before, self.screenshot()), 0.003)
        cube.location.x -= 2

    def test_images_are_read_when_they_change(self):
        from io_glint.export import images  # pylint: disable=import-outside-toplevel
        cube = next(ob for ob in self.scene.objects if ob.type == "MESH")
        material, image = bpy.data.materials.new("image"), bpy.data.images.new("image", 64, 64)
        material.use_nodes = True
        tree = material.node_tree
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = image
        tree.links.new(node.outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])
        old, cube.material_slots[0].material = cube.material_slots[0].material, material
        self.addCleanup(setattr, cube.material_slots[0], "material", old)
        lamp = next(ob for ob in self.scene.objects if ob.type == "LIGHT")
        with unittest.mock.patch.object(images, "content", wraps=images.content) as content:
            self.wait()
            dark, loads = self.screenshot(), self.viewport().renderer.loads
            lamp.data.energy += 10
            self.wait()
            lamp.data.energy -= 10
            self.wait()
            self.assertEqual((content.call_count, self.viewport().renderer.loads), (1, loads))
            image.pixels[:] = [1.0] * len(image.pixels)
            image.update_tag()  # as after a stroke of painting
            self.wait()
            self.assertEqual(content.call_count, 2)
        self.assertGreater(self.difference(dark, self.screenshot()), 0.01)

    def test_orbits_are_followed(self):
        self.space.region_3d.view_perspective, self.space.region_3d.view_distance = "PERSP", 6
        self.wait()
        before = self.screenshot()
        self.space.region_3d.view_rotation = self.space.region_3d.view_rotation @ Quaternion((0, 1, 0), 0.5)
        self.wait()
        self.assertGreater(self.difference(before, self.screenshot()), 0.003)

    def test_an_orbit_is_not_refined(self):
        """Between its pictures, Blender's time is for the next; afterwards, the last is."""
        self.scene.glint.aa = 3
        self.space.region_3d.view_perspective, self.space.region_3d.view_distance = "PERSP", 6
        self.wait()
        viewport = self.viewport()
        for _ in range(3):
            self.space.region_3d.view_rotation = self.space.region_3d.view_rotation @ Quaternion((0, 1, 0), 0.1)
            self.redraw()
            with unittest.mock.patch.object(viewport.renderer, "step") as step:
                viewport._calm_at = time.monotonic() + 0.05  # pylint: disable=protected-access
                self.assertGreater(viewport._refine(), 0)  # pylint: disable=protected-access
            step.assert_not_called()
        time.sleep(0.06)
        with unittest.mock.patch.object(viewport.renderer, "step") as step:
            viewport._refine()  # pylint: disable=protected-access
        step.assert_called_once()
        self.wait()

    def test_the_viewport_of_rt2(self):
        with bpy.context.temp_override(window=self.window):
            bpy.ops.glint.rt2_exercise()
        self.space.region_3d.view_perspective = "CAMERA"
        self.wait()
        phong = self.viewport().renderer.picture.copy()
        self.assertGreater(float(phong[..., :3].max()), 0.5)
        self.window.scene.glint.shading = "normals"
        self.wait()
        self.assertGreater(float(abs(self.viewport().renderer.picture - phong).max()), 0.2)

    def test_a_closed_viewport_is_gone(self):
        self.wait()
        viewport = weakref.ref(self.viewport())
        self.space.shading.type = "SOLID"
        self.redraw()
        from io_glint.viewport import viewports  # pylint: disable=import-outside-toplevel
        self.assertEqual(viewports(), [])
        self.assertIsNone(viewport())  # without Python's collector of cycles

    def test_a_large_mesh_that_was_hidden_is_shown_again(self):
        """Its file must still be there: Blender does not say that its geometry is new."""
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=5, location=(0, 0, 3))
        ball = bpy.context.object
        self.addCleanup(bpy.data.objects.remove, ball)
        self.wait()
        before = self.screenshot()
        for is_hidden in (True, False):
            ball.hide_set(is_hidden)
            self.wait()
        self.assertLess(self.difference(before, self.screenshot()), 1e-3)

    def test_without_the_package_the_viewport_says_what_to_install(self):
        from io_glint import python_module, viewport_message  # pylint: disable=import-outside-toplevel
        self.space.shading.type = "SOLID"
        self.redraw()
        drawn = []
        real = viewport_message.blf.draw
        with unittest.mock.patch.dict(sys.modules, {"glint": None}), \
                unittest.mock.patch.object(viewport_message.blf, "draw", lambda font, line: (drawn.append(line), real(font, line))):
            fault = python_module.find()[1]
            self.space.shading.type = "RENDERED"
            self.redraw()
            shown = self.screenshot()
            bpy.ops.object.select_all(action="INVERT")
            self.redraw()  # edits go on
        self.assertEqual(" ".join(drawn[:len(drawn) // 2]), fault)
        for words in ("is not installed", "F12", "Install", "-m pip install"):
            self.assertIn(words, fault)
        yellow = sum(r - b > 0.1 for r, b in zip(shown[2][0::4], shown[2][2::4]))
        self.assertGreater(yellow, 500)
        self.space.shading.type = "SOLID"
        self.redraw()
        self.space.shading.type = "RENDERED"
        self.wait()  # and it works when the package is there

    def test_an_error_is_shown_and_ends(self):
        self.scene.glint.picture, camera = "RT2", self.scene.camera
        self.scene.camera = None
        self.redraw()
        self.assertIn("no camera", self.viewport()._fault)  # pylint: disable=protected-access
        self.scene.camera, self.scene.glint.picture = camera, "BLENDER"
        self.wait()
        self.assertEqual(self.viewport()._fault, "")  # pylint: disable=protected-access
