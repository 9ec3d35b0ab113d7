# SPDX-License-Identifier: Apache-2.0
"""Quadrics of all types: whole, clipped, cut, transformed, in shadow, mirrored, from far away."""
from pov import CAMERA, FLOOR, GLAZE, LIGHT, SHINE, rule

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
MIRROR = "pigment { rgb 0.2 } finish { reflection 0.7 phong 0.6 }"
BOX = "box { -1, 1 }"


def quadrics(name, objects, camera=CAMERA, light=LIGHT):
    return rule("quadric_" + name, objects, head=HEAD + camera + light)


def quadric(squares, products, linear, constant, items="", look=SHINE):
    return f"quadric {{ <{squares}>, <{products}>, <{linear}>, {constant} {look} {items} }}\n"


CONE = "quadric { <1, -1, 1>, 0, 0, 0 }"
PARABOLOID = "quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 }"

RULES = [
    quadrics("ellipsoid", FLOOR + quadric("1, 2, 1.5", "0.5, -0.3, 0.2", "0, -2, 0", -0.4)),
    quadrics("paraboloid", FLOOR + quadric("1, 0, 1", "0, 0, 0", "0, 1, 0", -1.6)),
    quadrics("two_sheets", quadric("1, -1, 1", "0, 0, 0", "0, 0, 0", 0.3, "rotate 70*z translate 0.8*y")),
    quadrics("one_sheet", FLOOR + quadric("1, -1, 1", "0, 0, 0", "0, 0, 0", -0.3, "translate 1.2*y")),
    quadrics("saddle", quadric("1, 0, -1", "0, 0, 0", "0, 1, 0", 0, f"clipped_by {{ {BOX} }} rotate <-30, 25, 0> translate 0.8*y")),
    quadrics("cylinder", FLOOR + quadric("0, 1, 1", "0, 0, 0", "0, 0, 0", -0.3, "rotate 25*y translate 0.9*y")),
    quadrics("plane", quadric("0, 0, 0", "0, 0, 0", "0.2, 1, 0", 0.3)),
    quadrics("planes", quadric("0, 0, 0", "1, 0, 0", "0, 0, 0", 0, "rotate <-20, 0, 30> translate <0.4, -0.3, 0>")),
    quadrics("clipped", FLOOR + f"object {{ {PARABOLOID} {SHINE} clipped_by {{ {BOX} }} translate 0.6*y }}\n"),
    quadrics("clips", FLOOR + f"sphere {{ 0, 1 {SHINE} clipped_by {{ {CONE} }} rotate 60*z translate 0.9*y }}\n"),
    quadrics("cut", FLOOR + f"difference {{ {BOX} {PARABOLOID} {SHINE} rotate <-15, 35, 0> translate 0.6*y }}\n"),
    quadrics("intersection", FLOOR + f"intersection {{ {BOX} {CONE} {SHINE} rotate <25, 0, 30> translate 0.8*y }}\n"),
    quadrics("inverse", FLOOR + f"intersection {{ {BOX} quadric {{ <1, -1, 1>, 0, 0, -0.2 inverse }} {SHINE} rotate <-15, 35, 0> translate 0.6*y }}\n"),
    quadrics("sheared", FLOOR + quadric("1, 1, 1", "0, 0, 0", "0, 0, 0", -1, "matrix <1, 0.3, 0, 0.6, 1, 0, 0, 0.4, 1, 0, 0.9, 0>")),
    quadrics("shadow", FLOOR + f"intersection {{ {CONE} box {{ <-1, -1, -1>, <1, 0, 1> }} {SHINE} translate 1.3*y }}\n", CAMERA,
             "light_source { <3, 7, -2>, rgb 1 }\nlight_source { <-6, 1.2, -1>, rgb 0.5 }\n"),
    quadrics("mirrored", FLOOR + quadric("1, 3, 1", "0, 0, 0", "0, 0, 0", -1, "translate 0.6*y", MIRROR)),
    quadrics("clear", FLOOR + quadric("1, 3, 1", "0, 0, 0", "0, 0, 0", -1, "translate 0.6*y", GLAZE)),
    quadrics("far", quadric("1, 2, 1", "0, 0, 0", "0, 0, 0", -1, "rotate -50*x"), "camera { location <0, 2000, -4000> look_at 0 angle 0.06 }\n"),
]
