# SPDX-License-Identifier: Apache-2.0
"""Layered textures of POV-Ray's scenes, which glint reads as they are."""
from lights import Rule
from patterns import BALL, FLOOR, HEAD, PLACE

FINISH = "finish { ambient 0.3 diffuse 0.6 }"
SHINY = "finish { ambient 0.3 diffuse 0.6 phong 0.4 phong_size 20 reflection 0.2 }"
RINGS = "onion color_map { [0 rgb <0.9, 0.2, 0.1>] [0.5 rgb <0.1, 0.6, 0.2>] [1 rgb 0.9] } " + PLACE
LINES = "gradient x color_map { [0 rgbt <0.1, 0.2, 0.9, 0>] [0.6 rgbt <0.9, 0.8, 0.2, 1>] [1 rgbt <0.2, 0.3, 0.9, 0.3>] } scale 0.3"
SQUARES = "checker rgbt <1, 0.9, 0.2, 0.4> rgbt <0, 0, 0, 1> scale 0.25 rotate 20*z"


def layer(pigment, finish=FINISH):
    return f"texture {{ pigment {{ {pigment} }} {finish} }} "


def rule(name, objects):
    return Rule("layers_" + name, "povray", HEAD + FLOOR + objects, "")


def ball(name, *layers, after=""):
    return rule(name, BALL % ("".join(layers) + after))


DECLARED = f"#declare T = {layer(RINGS)}{layer(LINES)}\n"
RULES = [
    ball("transmit", layer("rgb <0.8, 0.4, 0.2>"), layer("rgbt <0.2, 0.6, 0.9, 0.25>")),
    ball("filter", layer("rgb <0.8, 0.4, 0.2>"), layer("rgbf <0.2, 0.6, 0.9, 0.75>")),
    ball("filter_transmit", layer("rgb <0.8, 0.4, 0.2>"), layer("rgbft <0.2, 0.6, 0.9, 0.5, 0.25>")),
    ball("three_colors", layer("rgb <0.8, 0.4, 0.2>"), layer("rgbt <0.2, 0.6, 0.9, 0.5>"), layer("rgbft <1, 0, 0, 0.3, 0.3>")),
    ball("opaque_top", layer(RINGS), layer("rgb <0.8, 0.4, 0.2>")),
    ball("see_through", layer("rgbt <0.8, 0.4, 0.2, 0.5>"), layer("rgbt <0.2, 0.6, 0.9, 0.5>")),
    ball("pattern_over_color", layer("rgb <0.8, 0.4, 0.2>"), layer(LINES)),
    ball("color_over_pattern", layer(RINGS), layer("rgbt <0.2, 0.6, 0.9, 0.6>")),
    ball("patterns", layer(RINGS), layer(LINES)),
    ball("three_patterns", layer(RINGS), layer(LINES), layer(SQUARES)),
    ball("color_between", layer(RINGS), layer("rgbt <0.2, 0.6, 0.9, 0.6>"), layer(SQUARES)),
    ball("see_through_pattern", layer("rgbt <0.8, 0.4, 0.2, 0.5>"), layer(LINES)),
    ball("patterns_see_through", layer(SQUARES), layer(LINES)),
    ball("shiny_top", layer(RINGS), layer(LINES, SHINY)),
    ball("emission", layer(RINGS, "finish { ambient 0 diffuse 0.5 emission 0.4 }"),
         layer(LINES, "finish { ambient 0 diffuse 0.5 emission 0.4 }")),
    ball("moved", layer(RINGS), layer(LINES), after="rotate 40*z scale 0.8"),
    ball("moved_between", layer(RINGS) + "rotate 40*z ", layer(LINES), after="scale 0.8 translate 0.2*y"),
    *[ball(f"finishes_{i}", layer(RINGS, a), layer(LINES, b)) for i, (a, b) in enumerate((
        ("finish { ambient 0.5 diffuse 0.3 }", FINISH), ("finish { ambient 0.1 diffuse 0.9 }", FINISH), ("finish { ambient 0 diffuse 0 }", FINISH),
        (FINISH, "finish { ambient 0 diffuse 0 }"), ("finish { ambient <0.2, 0.4, 0.1> diffuse 0.3 }", "finish { ambient <0.4, 0.8, 0.2> diffuse 0.6 }"),
        ("finish { ambient 0.5 diffuse 0.3 }", SHINY)))],
    ball("finishes_of_colors", layer("rgb <0.8, 0.4, 0.2>", "finish { ambient 0.5 diffuse 0.3 }"), layer("rgbt <0.2, 0.6, 0.9, 0.25>")),
    ball("finishes_of_three", layer(RINGS, "finish { ambient 0.5 diffuse 0.3 }"), layer(LINES, "finish { ambient 0 diffuse 0.9 }"), layer(SQUARES)),
    ball("finishes_see_through", layer("rgbt <0.8, 0.4, 0.2, 0.5>", "finish { ambient 0.5 diffuse 0.3 }"), layer(LINES)),
    ball("finish_below_opaque", layer(RINGS, "finish { ambient 0.5 phong 0.3 }"), layer("rgb <0.8, 0.4, 0.2>")),
    rule("declared", DECLARED + BALL % "texture { T }" + "box { <1.1, 0, 0>, <1.8, 1, 1> texture { T scale 0.6 rotate 30*z } }\n"),
    rule("declared_finish", DECLARED + BALL % f"texture {{ T {SHINY} }}"),
    rule("declared_pigment", DECLARED + BALL % "texture { T pigment { rgbt <0.2, 0.6, 0.9, 0.6> } }"),
    rule("declared_over", DECLARED + BALL % (layer("rgb y") + "texture { T }")),
    rule("declared_under", DECLARED + BALL % ("texture { T } " + layer(SQUARES))),
    rule("declared_pieces", f"#declare T = {layer(SQUARES)}{layer(LINES)}\n" + BALL % (layer(RINGS) + "texture { T scale 1.5 }")),
    rule("material", DECLARED + BALL % "material { texture { T } scale 0.5 }"),
    rule("material_layers", BALL % f"material {{ {layer(RINGS)}{layer(LINES)} rotate 20*z }}"),
    rule("union", "union { sphere { <-0.5, 0, 0>, 0.7 } box { 0, 0.9 } %s%s scale 0.8 rotate <10, 20, 30> }\n" % (layer(RINGS), layer(LINES))),
    rule("shadow", "light_source { <-3, 5, -2>, rgb 0.5 }\n" + BALL % (layer("rgbt <0.8, 0.4, 0.2, 0.5>") + layer("rgbt <0.2, 0.6, 0.9, 0.7>"))),
    rule("named_pattern", "#declare P = pigment { wood scale 0.3 rotate 20*x } #declare M = color_map { [0 rgb 0.2] [1 rgb <1, 0.7, 0.3>] }\n" +
         BALL % ("texture { pigment { P color_map { M } } %s } texture { pigment { P color_map { [0 rgbt <1, 0, 0, 0.2>] [1 rgbt 1] } "
                 "scale 1.7 } %s }" % (FINISH, FINISH))),
    rule("named_pattern_items", "#declare P = pigment { gradient y frequency 2 color_map { [0 rgb 0.2] [1 rgb <1, 0.7, 0.3>] } rotate 20*z }\n" +
         BALL % f"pigment {{ P phase 0.3 triangle_wave scale 0.7 }} {FINISH}"),
]
