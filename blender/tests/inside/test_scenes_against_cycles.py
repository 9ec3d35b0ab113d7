# SPDX-License-Identifier: Apache-2.0
"""Whole scenes with shadows, modifiers, highlights, images and colors, under each kind of light: glint's pictures are near those of
Cycles without indirect light."""
import math
import random

import bpy
from against_cycles import CyclesTest


class Scenes(CyclesTest):
    def setUp(self):
        super().setUp()
        self.scene.render.resolution_x, self.scene.render.resolution_y = 120, 68
        self.camera(location=(0, -8, 4))
        self.objects = [self.add("plane", size=20, material=self.material("floor", (0.6, 0.6, 0.55), Specular=0.0)),
                        self.add("uv_sphere", radius=0.9, location=(-2, 0, 0.9), smooth=True, material=self.paint("red", (0.8, 0.2, 0.1))),
                        self.add("cube", size=1.4, location=(0, 0.5, 0.7), rotation=(0, 0, 0.5), material=self.paint("blue", (0.1, 0.5, 0.8))),
                        self.add("monkey", size=1.8, location=(2, 0, 1), smooth=True, material=self.paint("gold", (0.9, 0.7, 0.1)))]
        self.objects[3].modifiers.new("smooth", "SUBSURF").render_levels = 2

    def paint(self, name, color):
        return self.material(name, color, Specular=0.3, Roughness=0.6)

    def check(self, most, samples=64):
        rms, _ = self.differences(samples)
        self.assertEqual(self.warnings, [])
        self.assertLess(rms, most)

    def node(self, ob, kind, **values):
        """A node that is linked to the color of an object."""
        tree = ob.data.materials[0].node_tree
        node = tree.nodes.new(kind)
        for key, value in values.items():
            setattr(node, key, value)
        tree.links.new(node.outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])

    def test_points(self):
        self.lamp("POINT", 600, (2, -3, 5))
        self.lamp("POINT", 200, (-4, -2, 3), shadow_soft_size=0.3)
        self.check(0.02)

    def test_a_sun(self):
        self.lamp("SUN", 3, rotation=(0.6, 0.3, 0), angle=0)
        self.check(0.03)

    def test_a_spot(self):
        self.lamp("SPOT", 900, (1, -3, 6), rotation=(0.45, 0.1, 0), spot_size=0.9, spot_blend=0.3, shadow_soft_size=0)
        self.check(0.02)

    def test_areas(self):
        self.lamp("AREA", 300, (1, -3, 5), rotation=(0.5, 0.2, 0), shape="RECTANGLE", size=2, size_y=1)
        self.lamp("AREA", 100, (-3, -2, 4), rotation=(0.3, -0.5, 0), shape="DISK", size=1)
        self.check(0.02, samples=256)

    def test_images(self):
        self.lamp("SUN", 2, rotation=(0.6, 0.3, 0), angle=0)
        self.lamp("POINT", 400, (2, -3, 4))
        image = bpy.data.images.new("waves", 128, 128)  # as smooth as a photograph
        image.pixels[:] = [0.5 + 0.4 * v for y in range(128) for x in range(128) for v in (
            math.sin(0.07 * x + 3 * math.sin(0.05 * y)), math.sin(0.08 * y + 2 * math.sin(0.04 * x)), math.sin(0.06 * (x + y)), 1)]
        for ob in self.objects:
            self.node(ob, "ShaderNodeTexImage", image=image)
        self.check(0.03)

    def test_colors_of_meshes(self):
        self.lamp("SUN", 2, rotation=(0.6, 0.3, 0), angle=0)
        self.lamp("POINT", 400, (2, -3, 4))
        values = random.Random(5)
        for i, ob in enumerate(self.objects):
            layer = ob.data.color_attributes.new("Color", "BYTE_COLOR" if i % 2 else "FLOAT_COLOR", "CORNER" if i < 2 else "POINT")
            for color in layer.data:
                color.color = (values.random(), values.random(), values.random(), 1)
            self.node(ob, "ShaderNodeVertexColor")
        self.check(0.03)
