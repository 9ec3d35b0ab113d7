# SPDX-License-Identifier: Apache-2.0
"""Lights: as bright as in Cycles over a Lambert surface; what glint has not is named."""
import math

import bpy
from against_cycles import CyclesTest
from support import SceneTest


class AgainstCycles(CyclesTest):
    def setUp(self):
        super().setUp()
        self.scene.render.resolution_x = self.scene.render.resolution_y = 24
        self.camera(location=(0, -0.01, 6), target=(0, 0, 0))
        self.plane = self.add("plane", size=30, material=self.lambert("grey", (0.5, 0.4, 0.3)))

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

    def test_spot(self):
        self.lamp("SPOT", 300, (0.5, 0.3, 2.5), (1, 0.7, 0.5), rotation=(0.2, 0.1, 0), spot_size=math.radians(50), spot_blend=0.3,
                  shadow_soft_size=0)
        rms, largest = self.differences()
        self.assertLess(rms, 2e-3)
        self.assertLess(largest, 0.02)

    def test_a_spot_with_a_hard_edge_and_a_wide_one(self):
        self.lamp("SPOT", 200, (0.5, 0, 2), spot_size=math.radians(40), spot_blend=0, shadow_soft_size=0)
        self.assertLess(self.differences(256)[0], 0.01)
        self.lamp("SPOT", 100, (-1, 0, 1), spot_size=math.pi, spot_blend=1, shadow_soft_size=0, name="wide")
        self.assertLess(self.differences(256)[0], 0.01)

    def test_areas(self):
        for shape in ("SQUARE", "RECTANGLE", "DISK", "ELLIPSE"):
            with self.subTest(shape=shape):
                lamp = self.lamp("AREA", 150, (0.6, 0.2, 1.5), (1, 0.6, 0.4), rotation=(0.4, -0.3, 0.2), shape=shape, size=1.2,
                                 size_y=0.6)
                lamp.scale = (1.5, 1, 1) if shape == "SQUARE" else (1, 1, 1)
                rms, _ = self.differences(256)
                self.assertLess(rms, 0.012)
                bpy.data.objects.remove(lamp)

    def test_an_area_has_no_back(self):
        self.lamp("AREA", 150, (0, 0, 2), rotation=(math.pi, 0, 0), size=1)
        self.export()
        self.assertEqual(max(self.layers("background")["beauty"].channels["R"]), 0)

    def test_a_point_with_a_radius(self):
        self.lamp("POINT", 400, (0.8, 0.3, 2.8), shadow_soft_size=0.4)
        # A sphere hangs between, so that its shadow has a penumbra.
        self.add("uv_sphere", radius=0.4, location=(0.4, 0.1, 0.6), segments=48, ring_count=24, smooth=True,
                 material=self.lambert("red", (0.7, 0.1, 0.1)))
        self.assertLess(self.differences(256)[0], 0.02)

    def test_a_light_that_is_very_near(self):
        self.lamp("POINT", 0.01, (0, 0, 0.004))
        self.export()
        value = self.layers("background", aa=9)["beauty"].channels["R"]
        self.assertGreater(max(value), 0)

    def test_a_light_without_shadows(self):
        self.lamp("POINT", 300, (0.2, 0.3, 3), use_shadow=False).data.cycles.cast_shadow = False
        self.add("plane", size=0.4, location=(0.2, 0.2, 1), material=self.lambert("red", (0.7, 0.1, 0.1)))
        self.assertIn("casts_shadows = false", self.export())
        self.assertLess(self.differences(256)[0], 0.01)

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

    def test_what_of_spots_and_areas_is_not_exported_is_named(self):
        self.lamp("SPOT", name="Stage", shadow_soft_size=3)
        self.lamp("AREA", name="Panel", spread=1)
        self.lamp("AREA", name="Egg", shape="ELLIPSE", size=2, size_y=1)
        self.lamp("AREA", name="Flat", shape="RECTANGLE", size=2, size_y=0)
        text = self.export()
        self.assertEqual(text.count("\nlight "), 3)
        self.assertEqual([w for w in self.warnings if "light" in w],
                         ["light 'Stage': its radius of 3 is ignored: shadows are hard",
                          "light 'Panel': its spread is ignored: it shines to all sides of its front",
                          "light 'Egg': its ellipse is exported as a rectangle of the same area",
                          "light 'Flat': left out: its size or scale of 0 leaves it no area"])

    def test_a_strong_light_is_accepted_without_a_warning(self):
        self.lamp("POINT", 3e7, (0, 0, 5))
        self.assertIn("light \"Key\"", self.export())
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"), "--strict")
        self.lamp("POINT", 5e7, name="Nova")
        self.assertNotIn("light \"Nova\"", self.export())
        self.assertEqual(sum("'Nova'" in w for w in self.warnings), 1)

    def test_a_wide_sun_is_named(self):
        self.lamp("SUN", angle=0.5, name="Wide")
        self.export()
        self.assertEqual(sum("'Wide'" in w for w in self.warnings), 1, self.warnings)

    def test_the_scale_of_lights(self):
        self.lamp("SUN", math.pi, name="Key")
        self.scene.glint.light_scale = 0.25
        self.assertIn("intensity = 0.25 ", self.export())

    def test_hidden_lights_are_off(self):
        self.lamp(name="Off").hide_render = True
        self.assertNotIn("Off", self.export())
