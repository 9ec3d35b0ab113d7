# SPDX-License-Identifier: Apache-2.0
"""Materials and lights: the formulas."""
import math
import types
import unittest

from io_glint.export import keys, light, phong
from io_glint.export.report import Report


class Phong(unittest.TestCase):
    def test_exponent(self):
        self.assertAlmostEqual(phong.exponent(0.5), 30)
        self.assertEqual(phong.exponent(1.0), 1)
        self.assertEqual(phong.exponent(0.0), 1e5)

    def test_plastic(self):
        m = phong.principled((0.5, 0.25, 0.1), roughness=0.5, specular=0.5)
        self.assertEqual(m.diffuse, (0.5, 0.25, 0.1))
        for channel in m.specular:
            self.assertAlmostEqual(channel, 0.04 * 32 / 8)
        self.assertEqual((m.mirror, m.transmission, m.ior), (0, 0, 1))

    def test_metals_keep_their_hue(self):
        m = phong.principled((1.0, 0.5, 0.25), metallic=1.0, roughness=0.3)
        self.assertEqual(m.specular, (1.0, 0.5, 0.25))
        self.assertEqual(m.diffuse, (0.5, 0.25, 0.125))
        self.assertEqual(m.mirror, 0)
        sharp = phong.principled((1.0, 0.5, 0.25), metallic=1.0, roughness=0.0)
        self.assertEqual((sharp.mirror, sharp.mirror_color, sharp.diffuse), (1, (1, 0.5, 0.25), (0, 0, 0)))

    def test_glass(self):
        m = phong.glass((0.5, 1.0, 1.0), 1.5)
        self.assertEqual((m.transmission, m.transmission_color, m.ior, m.shininess), (1, (0.25, 1, 1), 1.5, 2000))

    def test_mix_keeps_what_only_one_side_has(self):
        m = phong.mix(phong.diffuse((1.0, 0, 0)), phong.glass((0.5, 0.5, 0.5), 1.5), 0.5)
        self.assertEqual((m.diffuse, m.transmission, m.ior, m.transmission_color), ((0.5, 0, 0), 0.5, 1.5, (0.25,) * 3))
        self.assertIs(phong.mix(m, phong.diffuse((1, 1, 1)), 0), m)

    def test_add(self):
        m = phong.add(phong.diffuse((0.5, 0, 0)), phong.emission((0, 1.0, 0), 2.0))
        self.assertEqual((m.diffuse, m.emission), ((0.5, 0, 0), (0, 2, 0)))
        clear = phong.transparent((1, 1, 1))
        self.assertEqual(phong.add(clear, clear).transmission, 1)

    def test_ambient(self):
        self.assertEqual(phong.ambient(phong.diffuse((0.5, 0.5, 1.0)), (0.2, 0.4, 0.5)), (0.1, 0.2, 0.5))


class Keys(unittest.TestCase):
    def test_all_values_are_in_glints_ranges(self):
        for color in ((0.0,) * 3, (1.0, 0.5, 0.0), (1.0,) * 3):
            for metallic in (0.0, 0.5, 1.0):
                for roughness in (0.0, 0.1, 0.5, 1.0):
                    for transmission in (0.0, 0.5, 1.0):
                        made = keys.of_phong(phong.principled(color, metallic, roughness, 1.0, transmission), (0.1,) * 3)
                        self.assertLessEqual(max(made["specular_color"]), 1 + 1e-9)
                        self.assertTrue(0 <= made.get("mirror", 0) <= 1 and 0 <= made.get("transmission", 0) <= 1)
                        self.assertTrue(1 <= made["shininess"] <= 1e5)

    def test_replaced(self):
        base = keys.of_phong(phong.diffuse((0.5, 0.5, 0.5)), (0, 0, 0))
        report = Report()
        out = keys.replaced(base, {"glint_ambient": 0.3, "glint_diffuse_color": (1, 0, 0), "glint_ior": -1, "other": 1},
                            report, "material 'm'")
        self.assertEqual((out["ambient"], out["diffuse_color"]), (0.3, (1, 0, 0)))
        self.assertNotIn("ambient_color", out)
        self.assertEqual(len(report.warnings), 1)

    def test_bounded(self):
        report = Report()
        nan = float("nan")
        out = keys.bounded({"color": (nan, -1e9, 5.0), "mirror_color": (-1.0, 0.5, 1.0), "ior": 0.0, "shininess": nan,
                            "mirror": 0.5}, report, "material 'm'")
        self.assertEqual(out, {"color": (0, -1e6, 5), "mirror_color": (0, 0.5, 1), "ior": 1e-3, "shininess": 0, "mirror": 0.5})
        self.assertEqual(len(report.warnings), 4)

    def test_a_report_says_things_once(self):
        report = Report()
        for _ in range(3):
            report.warn("light 'a'", "left out")
        report.warn("light 'b'", "left out")
        self.assertEqual(report.warnings, ["light 'a': left out", "light 'b': left out"])


POINT = types.SimpleNamespace(shadow_soft_size=0)


class Lights(unittest.TestCase):
    def test_classical(self):
        self.assertAlmostEqual(light.classical("POINT", (1, 1, 1), 4 * math.pi ** 2)[0], 1)
        self.assertAlmostEqual(light.classical("SUN", (1, 0.5, 0), math.pi)[1], 0.5)
        self.assertAlmostEqual(light.classical("AREA", (1, 1, 1), 4 * math.pi)[0], 1)

    def test_spot_angles(self):
        self.assertEqual(light.spot_angles(math.pi / 2, 0), (45, 45))
        inner, outer = light.spot_angles(math.pi / 2, 1)
        self.assertAlmostEqual(inner, 0, places=5)
        self.assertAlmostEqual(outer, 45)
        self.assertEqual(light.spot_angles(math.pi, 0.5)[1], 90)

    def test_black_and_negative(self):
        self.assertIn("intensity = 0", light.point_block("L", (0, 0, 0), (0, 0, 0), POINT, 4))
        self.assertIn("color = (-1, -0.5, 0)", light.sun_block("L", (0, 0, 1), (-2, -1, 0), POINT))
