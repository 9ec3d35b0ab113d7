# SPDX-License-Identifier: Apache-2.0
"""Quartics, cubics and polys: closed ones and ones without ends, clipped, cut, transformed, mirrored, clear. Each has
`sturm`: without it, POV-Ray loses hits near edges."""
from pov import CAMERA, FLOOR, GLAZE, LIGHT, SHINE, rule

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
MIRROR = "pigment { rgb 0.2 } finish { reflection 0.7 phong 0.6 }"
BOX = "box { -1, 1 }"
TERMS = (
    "x4 x3y x3z x3 x2y2 x2yz x2y x2z2 x2z x2 xy3 xy2z xy2 xyz2 xyz xy xz3 xz2 xz x y4 y3z y3 y2z2 y2z y2 yz3 yz2 yz y "
    "z4 z3 z2 z constant"
).split()


def degree(term):
    return 0 if term == "constant" else sum(int(c) - 1 if c.isdigit() else 1 for c in term)


def coefficients(order, terms):
    return "<" + ", ".join(str(terms.get(t, 0)) for t in TERMS if degree(t) <= order) + ">"


def quartics(name, objects, camera=CAMERA, light=LIGHT):
    return rule("quartic_" + name, objects, head=HEAD + camera + light)


def quartic(items="", look=SHINE, **terms):
    return f"quartic {{ {coefficients(4, terms)} sturm {look} {items} }}\n"


GOURSAT = dict(x4=1, y4=1, z4=1, x2=-1, y2=-1, z2=-1, constant=0.38)
DROP = dict(x4=1, x3=-2, y2=1, z2=1)
CAYLEY = f"cubic {{ {coefficients(3, dict(x2=1, y2=1, z2=1, xyz=2, constant=-1))} sturm }}"
RING = dict(x4=1, y4=0.0625, z4=1, x2y2=0.5, x2z2=2, y2z2=0.5, x2=-2.08, y2=0.48, z2=-2.08, constant=0.9216)
ALL = {t: round(0.04 * ((7 * i) % 11 - 5), 2) for i, t in enumerate(TERMS)}
CLOSED = {**ALL, "x4": 1, "y4": 1.2, "z4": 0.9, "x2y2": 0.5, "constant": -0.5}

RULES = [
    quartics("windows", FLOOR + quartic("rotate <-15, 30, 0> translate 0.9*y", **GOURSAT)),
    quartics("drop", FLOOR + quartic("rotate -90*z translate 1.9*y", **DROP)),
    quartics("ring", FLOOR + quartic("translate 0.5*y", **RING)),
    quartics("all_terms", FLOOR + quartic("translate 0.9*y", **CLOSED)),
    quartics("sheared", FLOOR + quartic("matrix <1, 0.3, 0, 0.6, 1, 0, 0, 0.4, 1, 0, 0.9, 0>", **CLOSED)),
    quartics("far", quartic("rotate -50*x", **GOURSAT), "camera { location <0, 40, -80> look_at 0 angle 3 }\n"),
    quartics("mirrored", FLOOR + quartic("translate 0.5*y", MIRROR, **RING)),
    quartics("clear", FLOOR + quartic("translate 0.9*y", GLAZE, **GOURSAT)),
    quartics("clipped", FLOOR + quartic(f"clipped_by {{ {BOX} }} rotate 20*y translate 0.9*y", **ALL)),
    quartics("clips", FLOOR + f"sphere {{ 0, 1 {SHINE} clipped_by {{ {quartic(look='', **RING)} }} rotate 60*z translate 0.9*y }}\n"),
    quartics("cubic", FLOOR + f"object {{ {CAYLEY} {SHINE} clipped_by {{ sphere {{ 0, 1.5 }} }} rotate 15*y scale 0.7 translate 0.9*y }}\n"),
    quartics("cut", FLOOR + f"difference {{ {BOX} {quartic(look='', **GOURSAT)} {SHINE} rotate <-15, 35, 0> translate 0.9*y }}\n"),
    quartics("intersection", FLOOR + f"intersection {{ {BOX} {CAYLEY} {SHINE} rotate <25, 0, 30> translate 0.9*y }}\n"),
    quartics("inverse", FLOOR + f"intersection {{ {BOX} quartic {{ {coefficients(4, DROP)} sturm inverse }} {SHINE} rotate <-15, 35, 0> translate 0.9*y }}\n"),
    quartics("poly_4", FLOOR + f"poly {{ 4, {coefficients(4, GOURSAT)} sturm {SHINE} translate 0.9*y }}\n"),
    quartics("poly_3", FLOOR + f"poly {{ 3, {coefficients(3, dict(x2=1, z2=1, y3=1, y2=-1))} sturm {SHINE} clipped_by {{ {BOX} }} translate 0.9*y }}\n"),
    quartics("poly_2", FLOOR + f"poly {{ 2, {coefficients(2, dict(x2=1, y2=2, z2=1, xz=0.5, constant=-0.6))} {SHINE} translate 0.6*y }}\n"),
    quartics("endless", quartic("rotate <-20, 30, 0>", **{"x4": 1, "y4": 1, "x2": -0.5, "z2": -0.3, "constant": 0.01})),
    quartics("plane", FLOOR + f"intersection {{ {BOX} {quartic(look='', y=1, x=0.2, constant=-0.3)} {SHINE} translate 0.9*y }}\n"),
    quartics("patterned", FLOOR + quartic("rotate <-15, 30, 0> translate 0.9*y", "pigment { checker rgb 1, rgb <1, 0, 0> scale 0.3 } finish { phong 0.6 }", **GOURSAT)),
]
