# SPDX-License-Identifier: Apache-2.0
"""Tori and discs with a hole: plain, transformed, in shadow, mirrored, thin, from far away, and that intersect themselves."""
from pov import CAMERA, FLOOR, GLAZE, LIGHT, SHINE, rule

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
ABOVE = "camera { location <0, 4, -5> look_at <0, 0.3, 0> angle 50 }\n"
MIRROR = "pigment { rgb 0.2 } finish { reflection 0.7 phong 0.6 }"


def tori(name, objects, camera=CAMERA, light=LIGHT):
    return rule("torus_" + name, objects, head=HEAD + camera + light)


def torus(radii, items, look=SHINE):
    return f"torus {{ {radii} {look} {items} }}\n"


RULES = [
    tori("plain", torus("1.4, 0.5", ""), ABOVE),
    tori("sturm", FLOOR + torus("1.2, 0.3", "sturm rotate -60*x translate 0.7*y")),
    tori("scaled", FLOOR + torus("1, 0.3", "scale <1.4, 2.5, 0.7> rotate <30, 20, 0> translate 0.5*y")),
    tori("sheared", FLOOR + torus("1, 0.35", "matrix <1, 0.3, 0, 0.6, 1, 0, 0, 0.4, 1, 0, 0.6, 0>")),
    tori("rotated", FLOOR + "".join(torus("0.5, 0.15", f"rotate <{30 * i}, {50 * i}, {20 * i}> translate <{i % 3 * 1.3 - 1.3}, {i // 3 * 1.2}, 0>")
                                    for i in range(6))),
    # Their shadows on each other, on themselves and on the floor.
    tori("shadow", FLOOR + torus("1.3, 0.35", "rotate -20*x") + torus("0.6, 0.1", "translate <0.2, 0.9, -0.3>"), ABOVE,
         "light_source { <3, 7, -2>, rgb 1 }\nlight_source { <-6, 1.2, -1>, rgb 0.5 }\n"),
    tori("mirrored", FLOOR + torus("1.3, 0.5", "rotate -50*x translate 0.5*y", MIRROR) + torus("0.4, 0.15", "rotate 90*x translate <0, 0.6, -0.6>")),
    tori("clear", FLOOR + torus("1.3, 0.4", "rotate -60*x translate 0.6*y", GLAZE) + "sphere { <0, 0.6, 1>, 0.6 pigment { rgb x } }\n"),
    tori("thin", "".join(torus(f"{0.3 + 0.2 * i}, {0.03 / 2 ** i}", f"rotate {25 * i}*x") for i in range(6))),
    tori("far", torus("1.4, 0.5", "rotate -50*x"), "camera { location <0, 2000, -4000> look_at 0 angle 0.06 }\n"),
    # The tube's radius is that of the ring, or greater.
    tori("horn", FLOOR + torus("0.7, 0.7", "rotate -60*x translate 0.3*y")),
    tori("spindle", FLOOR + torus("0.5, 0.9", "rotate -50*x translate 0.3*y")),
    tori("glass", FLOOR + "torus { 1, 0.4 pigment { rgbf 1 } finish { phong 0.8 } interior { ior 1.5 } rotate -50*x translate 0.5*y }\n"
         "cylinder { <-3, 0, 1.6>, <3, 0.5, 1.6>, 0.3 pigment { rgb <1, 0, 0> } }\n"),
    tori("fog", FLOOR + torus("4, 0.8", "translate 0.9*y", GLAZE) + f"sphere {{ <0, 0.5, 0>, 0.6 {SHINE} }}\n"
         "fog { distance 6 color rgb <0.7, 0.7, 0.8> }\n"),
    tori("disc", FLOOR + f"disc {{ <-0.8, 0.8, 0>, <0.3, 0.5, -1>, 0.9, 0.4 {SHINE} }}\n"
         f"disc {{ 0, y, 1, 0.6 {MIRROR} scale <0.9, 1, 0.5> rotate <-50, 30, 0> translate <1, 0.9, 0> }}\n"
         f"disc {{ <0, 2.2, 0>, y, 0.7, -0.3 {SHINE} }}\ndisc {{ <0, 0.4, -1>, -z, 0.3, 0.5 {SHINE} }}\ndisc {{ <1.6, -0.3, -1>, -z, -0.4, 0.1 {SHINE} }}\n"),
]
