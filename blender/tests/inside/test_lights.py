# SPDX-License-Identifier: Apache-2.0
"""Lights: as bright as in Cycles over a Lambert surface; what glint has not is named."""
import math

import bpy
from io_glint import exr
from support import SceneTest


class AgainstCycles(SceneTest):
    def setUp(self):
        super().setUp()
        self.scene.render.resolution_x = self.scene.render.resolution_y = 24
        self.camera(location=(0, -0.01, 6), target=(0, 0, 0))
        self.plane = self.add("plane", size=30, material=self.lambert("grey", (0.5, 0.4, 0.3)))

    def lambert(self, name, color):
        material = bpy.data.materials.new(name)
        material.use_nodes = True
        tree = material.node_tree
        tree.nodes.clear()
        node, output = tree.nodes.new("ShaderNodeBsdfDiffuse"), tree.nodes.new("ShaderNodeOutputMaterial")
        node.inputs["Color"].default_value = (*color, 1)
        tree.links.new(node.outputs[0], output.inputs["Surface"])
        return material

    def cycles(self, samples):
        render = self.scene.render
        render.engine = "CYCLES"
        cycles = self.scene.cycles
        cycles.device, cycles.samples, cycles.use_denoising, cycles.max_bounces = "CPU", samples, False, 0
        cycles.pixel_filter_type = "BOX"
        settings = render.image_settings
        settings.file_format, settings.color_depth, settings.exr_codec, settings.color_mode = "OPEN_EXR", "32", "ZIP", "RGB"
        render.filepath = self.path("cycles.exr")
        bpy.ops.render.render(write_still=True)
        return exr.read(render.filepath)[0]

    def check_ratio(self, tolerance=0.02, samples=16):
        self.export()
        ours = self.layers("background")["beauty"]
        theirs = self.cycles(samples)
        for channel in "RGB":
            a, b = ours.channels[channel], theirs.channels[channel]
            self.assertGreater(min(b), 0)
            worst = max(abs(x / y - 1) for x, y in zip(a, b))
            self.assertLess(worst, tolerance, channel)

    def test_point(self):
        self.lamp("POINT", 300, (1, 0.5, 2.5), (1, 0.6, 0.3))
        self.check_ratio()

    def test_point_of_a_scaled_parent(self):
        parent = self.link(bpy.data.objects.new("parent", None))
        parent.scale, parent.location = (2, 2, 2), (0.5, 0, 0)
        self.lamp("POINT", 300, (0.5, 0.5, 1.5)).parent = parent
        self.check_ratio()

    def test_sun(self):
        self.lamp("SUN", 2.5, color=(1, 0.9, 0.5), rotation=(0.5, 0.3, 0.7), angle=0)
        self.check_ratio()

    def test_several_with_nodes(self):
        lamp = self.lamp("POINT", 200, (-1, 1, 2), (1, 1, 0.5)).data
        lamp.use_nodes = True
        emission = lamp.node_tree.nodes["Emission"]
        emission.inputs["Color"].default_value, emission.inputs["Strength"].default_value = (0.5, 1, 1, 1), 1.5
        self.lamp("SUN", 1.0, rotation=(-0.4, 0, 0), angle=0)
        self.check_ratio(samples=1024)  # Cycles chooses one of the lights for each sample

    def test_the_world_is_ambient_light(self):
        self.world((0.2, 0.3, 0.4), 2.0)
        self.export()
        ours = self.layers("background")["beauty"]
        self.scene.cycles.max_bounces = 1
        for channel, expected in zip("RGB", (0.5 * 0.4, 0.4 * 0.6, 0.3 * 0.8)):
            for value in ours.channels[channel]:
                self.assertAlmostEqual(value, expected, places=5)


class Lights(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.add("cube")

    def test_spot_and_area_are_named_and_left_out(self):
        self.lamp("SPOT", name="Stage")
        self.lamp("AREA", name="Panel")
        text = self.export()
        self.assertNotIn("\nlight ", text)
        self.assertEqual([w for w in self.warnings if "light" in w],
                         ["light 'Stage': left out: glint has no spot lights",
                          "light 'Panel': left out: glint has no area lights"])

    def test_a_strong_light_is_accepted_without_a_warning(self):
        self.lamp("POINT", 3e7, (0, 0, 5))
        self.assertIn("light \"Key\"", self.export())
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"), "--strict")
        self.lamp("POINT", 5e7, name="Nova")
        self.assertNotIn("light \"Nova\"", self.export())
        self.assertEqual(sum("'Nova'" in w for w in self.warnings), 1)

    def test_soft_and_shadowless_lights_are_named(self):
        self.lamp("POINT", shadow_soft_size=3.0, name="Soft")
        self.lamp("SUN", angle=0.5, name="Wide")
        self.lamp("POINT", use_shadow=False, name="Bare")
        self.export()
        for name in ("Soft", "Wide", "Bare"):
            self.assertEqual(sum(f"'{name}'" in w for w in self.warnings), 1, self.warnings)

    def test_the_scale_of_lights(self):
        self.lamp("SUN", math.pi, name="Key")
        self.scene.glint.light_scale = 0.25
        self.assertIn("intensity = 0.25 ", self.export())

    def test_hidden_lights_are_off(self):
        self.lamp(name="Off").hide_render = True
        self.assertNotIn("Off", self.export())
