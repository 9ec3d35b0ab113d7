# SPDX-License-Identifier: Apache-2.0
"""prism and lathe, sphere_sweep with linear splines, and polygons with holes."""
from pov import CAMERA, FLOOR, LIGHT, SHINE, rule

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 12 }\n"
BLUE = "pigment { rgb <0.2, 0.3, 0.9> } finish { phong 0.5 }"
CLEAR = "pigment { rgbt <0.9, 0.3, 0.2, 0.6> } finish { phong 0.5 }"
MIRROR = "pigment { rgb 0.2 } finish { reflection 0.7 phong 0.6 }"
TURN = "rotate <-25, 35, 0> translate 0.8*y"
SIDE_LIGHTS = "light_source { <5, 3, -2>, rgb 1 }\nlight_source { <-6, 4, -3>, rgb 0.5 }\n"
SQUARE = "<-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"
ARROW = "<-0.6, -1>, <0.4, -0.9>, <0.1, 0>, <0.9, 0.8>, <-0.9, 0.4>, <-0.6, -1>"
STAR = "<0, 1>, <0.6, -0.8>, <-0.95, 0.3>, <0.95, 0.3>, <-0.6, -0.8>, <0, 1>"
HOLES = SQUARE + ", <-0.6, -0.6>, <-0.1, -0.6>, <-0.3, 0.5>, <-0.6, -0.6>, <0.2, -0.3>, <0.7, -0.2>, <0.6, 0.6>, <0.2, 0.4>, <0.2, -0.3>"
ISLAND = SQUARE + ", <-0.7, -0.7>, <0.7, -0.7>, <0.7, 0.7>, <-0.7, 0.7>, <-0.7, -0.7>, <-0.3, -0.3>, <0.3, -0.3>, <0, 0.4>, <-0.3, -0.3>"
# The edges of one go through those of the other, and a side of the third lies on one of the first.
CROSSING = SQUARE + ", <-0.5, -0.2>, <1.5, -0.4>, <1.2, 0.6>, <-0.5, 0.4>, <-0.5, -0.2>, <1, -1>, <1, -0.5>, <0.6, -0.5>, <0.6, -1>, <1, -1>"
VASE = "7, <0, 0>, <0.6, 0>, <0.9, 0.5>, <0.9, 0.8>, <0.3, 1.3>, <0.7, 1.7>, <0.5, 1.7>"
SPHERES = "4, <-1.2, 0.4, 0>, 0.4, <-0.3, 1.5, 0.4>, 0.2, <0.5, 0.6, -0.4>, 0.5, <1.4, 1, 0>, 0.1"

# The first points, and of cubic ones also the last, are not drawn.
LEAF = "<-0.3, 0.9>, <-0.9, -0.8>, <0.9, -0.9>, <0.3, 0.2>, <0.8, 0.8>, <-0.5, 0.7>, <-0.9, -0.8>"
LEAF_HOLE = ", <0.1, 0.3>, <-0.4, -0.4>, <0.3, -0.5>, <0, 0.1>, <-0.4, -0.4>"
CUBIC = LEAF + ", <1, -1>" + LEAF_HOLE + ", <0.5, 0>"
ROUND = "<0.9, 0>, <0.9, 0.7>, <0.4, 0.9>, <0, 0.9>, <0, 0.9>, <-1.5, 0.9>, <-0.9, -0.9>, <0, -0.9>, <0, -0.9>, <0.5, -0.9>, <0.9, -0.5>, <0.9, 0>"
ROUND_HOLE = ", <0.3, 0>, <0.3, 0.8>, <-0.6, 0.3>, <-0.3, 0>, <-0.3, 0>, <-0.3, -0.4>, <0.3, -0.4>, <0.3, 0>"
BOWL = "<0, 0>, <0.9, 0>, <0.9, 0.4>, <0.3, 0.8>, <0.3, 0.8>, <0, 1>, <0.4, 1.4>, <0.8, 1.5>"


def sweeps(name, objects, camera=CAMERA, light=LIGHT):
    return rule("sweep_" + name, FLOOR + objects, head=HEAD + camera + light)


def prism(points, heights="-0.4, 0.5", words="linear_spline", end="", items=SHINE + " " + TURN):
    return f"prism {{ {words} {heights}, {points.count('<')}, {points} {end} {items} }}\n"


def lathe(points, items=SHINE, words="linear_spline"):
    return f"lathe {{ {words} {points} {items} }}\n"


def sweep(spheres=SPHERES, items=SHINE):
    return f"sphere_sweep {{ linear_spline {spheres} {items} }}\n"


def polygon(points, items=SHINE + " rotate <20, 25, 0> translate 0.6*y"):
    return f"polygon {{ {points.count('<')}, {points} {items} }}\n"


WORM = "7, <-1.2, 0.4, 0>, 0.1, <-0.9, 0.9, 0>, 0.15, <-0.4, 0.3, 0.3>, 0.25, <0, 0.9, 0>, 0.15, <0.4, 0.3, -0.3>, 0.1, <0.9, 1, 0>, 0.2, <1.2, 0.4, 0>, 0.1 tolerance 1e-6"

RULES = [
    *[sweeps("spheres_" + kind, f"sphere_sweep {{ {kind} {WORM} {SHINE} }}\n") for kind in ("b_spline", "cubic_spline")],
    sweeps("prism", prism(ARROW)),
    sweeps("prism_heights", prism(ARROW, "0.5, -0.4", "linear_sweep linear_spline")),
    sweeps("prism_plain", prism(ARROW, words="")),
    sweeps("prism_open", prism(ARROW, end="open")),
    sweeps("prism_holes", prism(HOLES)),
    sweeps("prism_holes_open", prism(HOLES, end="open")),
    sweeps("prism_island", prism(ISLAND)),
    sweeps("prism_crossing", prism(CROSSING)),
    sweeps("prism_star", prism(STAR)),
    sweeps("prism_not_closed", prism(SQUARE + ", <-0.5, -0.5>, <0.5, -0.5>, <0.2, 0.5>")),
    sweeps("prism_conic", prism(HOLES, "0.4, 1.3", "conic_sweep", items=SHINE + " rotate 200*x translate 1.2*y")),
    sweeps("prism_conic_both", prism(ARROW, "-0.8, 1", "linear_spline conic_sweep", items=SHINE + " scale 0.8 rotate <-20, 30, 20> translate 0.8*y")),
    sweeps("prism_conic_open", prism(SQUARE, "0, 1.2", "conic_sweep", "open", SHINE + " rotate <-50, 30, 20> translate 0.3*y")),
    sweeps("prism_shadow", prism(HOLES, items=BLUE + " rotate <-80, 15, 0> translate y"), light=SIDE_LIGHTS),
    sweeps("prism_clear", prism(ISLAND, items=CLEAR + " " + TURN)),
    sweeps("prism_mirrored", prism(HOLES, items=MIRROR + " rotate -90*x translate y")),
    sweeps("prism_sheared", prism(HOLES, items=SHINE + " matrix <1, 0.3, 0, 0.4, 0.7, 0.2, 0.1, 0, 1, 0, 0.6, 0>")),
    sweeps("polygon_hole", polygon(HOLES)),
    sweeps("polygon_island", polygon(ISLAND)),
    sweeps("polygon_star", polygon(STAR)),
    sweeps("polygon_crossing", polygon(CROSSING)),
    sweeps("polygon_steep", polygon("<-1, 0, -0.5>, <1, 0, 0.5>, <1, 2, 0.5>, <-1, 2, -0.5>, <-1, 0, -0.5>, <-0.5, 0.5, -0.25>, <0.5, 0.5, 0.25>, <0, 1.6, 0>, <-0.5, 0.5, -0.25>", SHINE)),
    sweeps("polygon_flat", polygon("<-1, 0.3, -1>, <1, 0.3, -1>, <1, 0.3, 1>, <-1, 0.3, 1>, <-1, 0.3, -1>, <-0.5, 0.3, -0.5>, <0.5, 0.3, -0.5>, <0, 0.3, 0.6>, <-0.5, 0.3, -0.5>", SHINE), light=SIDE_LIGHTS),
    sweeps("polygon_clear", polygon(HOLES, CLEAR + " rotate <20, 25, 0> translate 0.6*y")),
    sweeps("disc_hole", f"disc {{ <0, 0.8, 0>, <0.3, 0.6, -1>, 1.1, 0.5 {SHINE} }}\ndisc {{ 0, y, 1, 0.6 {BLUE} rotate -40*x scale <1, 1.4, 0.8> translate <0, 0.6, 1> }}\n"),
    sweeps("lathe", lathe(VASE)),
    sweeps("lathe_plain", lathe(VASE, words="")),
    sweeps("lathe_from_above", lathe(VASE, SHINE + " rotate -60*x translate 0.5*y")),
    sweeps("lathe_rings", lathe("6, <0.2, 0>, <1, 0>, <1, 0.3>, <0.5, 0.3>, <0.5, 1.2>, <0.1, 1.2>", SHINE + " rotate -30*x")),
    sweeps("lathe_clear", lathe(VASE, CLEAR)),
    sweeps("lathe_shadow", lathe(VASE, BLUE + " scale <1.2, 0.8, 0.6> rotate 40*z"), light=SIDE_LIGHTS),
    sweeps("lathe_mirrored", lathe(VASE, MIRROR)),
    sweeps("lathe_from_inside", lathe("4, <0, 0>, <3, 0>, <4, 2>, <1, 4>"), camera="camera { location <0, 1, -2.5> look_at <0, 0.8, 0> angle 80 }\n", light="light_source { <0, 1.5, -1>, rgb 1 }\n"),
    sweeps("prism_quadratic", prism(LEAF, words="quadratic_spline")),
    sweeps("prism_quadratic_holes", prism(LEAF + LEAF_HOLE, words="quadratic_spline")),
    sweeps("prism_cubic", prism(CUBIC, words="linear_sweep cubic_spline")),
    sweeps("prism_cubic_open", prism(CUBIC, words="cubic_spline", end="open", items=SHINE + " rotate <-60, 35, 0> translate 0.8*y")),
    sweeps("prism_cubic_conic", prism(CUBIC, "0.4, 1.3", "conic_sweep cubic_spline", items=SHINE + " rotate 200*x translate 1.2*y")),
    sweeps("prism_bezier", prism(ROUND + ROUND_HOLE, words="bezier_spline")),
    sweeps("prism_bezier_conic", prism(ROUND, "-0.8, 1", "bezier_spline conic_sweep", items=SHINE + " scale 0.8 rotate <-20, 30, 20> translate 0.8*y")),
    sweeps("prism_bezier_mirrored", prism(ROUND + ROUND_HOLE, items=MIRROR + " rotate <-60, 20, 0> translate y", words="bezier_spline")),
    sweeps("prism_bezier_clear", prism(ROUND + ROUND_HOLE, items=CLEAR + " sturm " + TURN, words="bezier_spline")),
    sweeps("lathe_quadratic", lathe(VASE, words="quadratic_spline")),
    sweeps("lathe_cubic", lathe(VASE, words="cubic_spline")),
    sweeps("lathe_cubic_from_above", lathe(VASE, SHINE + " sturm rotate -60*x translate 0.5*y", "cubic_spline")),
    sweeps("lathe_bezier", lathe("8, " + BOWL, words="bezier_spline")),
    sweeps("lathe_bezier_apart", lathe("8, " + BOWL.replace("<0.3, 0.8>, <0, 1>", "<0.6, 0.7>, <0, 1>"), words="bezier_spline")),
    sweeps("lathe_bezier_mirrored", lathe("8, " + BOWL, MIRROR, "bezier_spline")),
    sweeps("lathe_cubic_clear", lathe(VASE, CLEAR, "cubic_spline")),
    sweeps("lathe_cubic_shadow", lathe(VASE, BLUE + " scale <1.2, 0.8, 0.6> rotate 40*z", "cubic_spline"), light=SIDE_LIGHTS),
    sweeps("spheres", sweep()),
    sweeps("spheres_equal", sweep("3, <-1, 0.3, 0>, 0.3, <0, 1.4, 0>, 0.3, <1, 0.3, 0.5>, 0.3")),
    sweeps("spheres_within", sweep("3, <-0.5, 0.8, 0>, 0.9, <-0.3, 0.9, -0.1>, 0.4, <1.3, 0.8, 0>, 0.3")),
    sweeps("spheres_point", sweep("2, <-1.2, 0.2, 0>, 0, <0.7, 0.9, 0>, 0.8")),
    sweeps("spheres_tolerance", sweep(SPHERES + " tolerance 0.01")),
    sweeps("spheres_clear", sweep(items=CLEAR)),
    sweeps("spheres_shadow", sweep(items=BLUE + " scale <1, 1.2, 0.7> rotate 20*y"), light=SIDE_LIGHTS),
    sweeps("spheres_mirrored", sweep(items=MIRROR)),
    sweeps("spheres_clipped", sweep(items=SHINE + " clipped_by { plane { <0.2, 0.3, -1>, 0.35 } }")),
    sweeps("spheres_clear_clipped", sweep(items=CLEAR + " clipped_by { plane { <0.2, 0.3, 1>, 0.35 } }")),
    sweeps("prism_clipped", prism(HOLES, items=SHINE + " clipped_by { plane { x + z, 0.3 } } " + TURN)),
    sweeps("spheres_in_solid", f"difference {{ box {{ <-1.2, 0, -0.3>, <1.2, 1.6, 0.6> {SHINE} }} sphere_sweep {{ linear_spline {SPHERES} {BLUE} }} rotate 20*y }}\n"),
]
