# SPDX-License-Identifier: Apache-2.0
"""Light that is lost in transparent objects, and made brighter: fade_distance, fade_power, fade_color and caustics of an interior."""
from pov import CAMERA, LIGHT, rule
from refraction import BALL, BOX, HEAD, ROOM, SHAPES

AMBER = "fade_distance 0.6 fade_power 1 fade_color <0.9, 0.5, 0.1>"


def fading(name, objects, head=HEAD):
    return rule("fade_" + name, ROOM + objects, head=head + CAMERA + LIGHT)


def clear(fade=AMBER, pigment="rgbf 1", finish="ambient 0 diffuse 0"):
    return f"pigment {{ {pigment} }} finish {{ {finish} }} interior {{ {fade} }} "


def caustics(name, objects):
    return rule("caustics_" + name, ROOM + objects, head=HEAD + CAMERA + LIGHT)


GLASS = clear("ior 1.4 " + AMBER)
RULES = [
    *[fading(f"power_{power}".replace(".", "_"), BALL + clear(f"fade_distance 0.8 fade_power {power}") + "}")
      for power in (0, 0.5, 1, 2, 3, 999, 1000, 1500)],
    fading("exponential_color", BALL + clear("fade_distance 0.8 fade_power 1001 fade_color <0.9, 0.5, 0.1>") + "}"),
    fading("two_interiors", BALL + clear("ior 1.3") + "interior { " + AMBER + " } }"),
    fading("material_after", BALL + "interior { ior 1.5 " + AMBER + " } material { texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } } interior { ior 1.2 } } }"),
    fading("named_material_after", "#declare M = material { texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } } };\n" + BALL + "interior { ior 1.5 " + AMBER + " } material { M } }"),
    *[fading(f"least_distance_{i}", BALL + clear(f"ior 1.2 fade_distance {d} fade_power 1") + "}") for i, d in enumerate((1e-10, 9.9e-11))],
    *[fading("fresnel_conserve_" + str(i), BOX + clear("ior 1.5 " + AMBER, finish="ambient 0 diffuse 0 reflection { " + reflection + " } conserve_energy") + "rotate 30*y }")
      for i, reflection in enumerate(("1 fresnel", "0.2, 1 fresnel"))],
    fading("pattern_inside", BALL + GLASS + "} sphere { <0.1, 1, 0>, 0.5 pigment { checker rgbt <1, 0.3, 0.2, 0.6> rgbt <0.2, 0.3, 1, 0.8> scale 0.3 } finish { ambient 0.2 diffuse 0.4 } }"),
    fading("without_power", BALL + clear("fade_distance 0.8") + "}"),
    fading("without_distance", BALL + clear("fade_power 2") + "}"),
    fading("color", BALL + clear() + "}"),
    fading("named", f"#declare I = interior {{ {AMBER} }}\n" + BALL + clear().replace(AMBER, "I fade_power 2") + "}"),
    fading("own_light", BALL + clear(AMBER, "rgbt <0.6, 0.9, 0.7, 0.6>", "ambient 0.1 diffuse 0.6 phong 0.5") + "}"),
    fading("filter", BALL + clear(AMBER, "rgbft <0.6, 0.9, 0.7, 0.6, 0.2>") + "}"),
    fading("mirror", BALL + clear(AMBER, "rgbt <1, 1, 1, 0.8>", "ambient 0 diffuse 0.1 reflection 0.3") + "}"),
    fading("sphere", BALL + GLASS + "}"),
    *[fading(name, before + GLASS + after) for name, (before, after) in SHAPES.items()],
    fading("total_reflection", BOX + clear("ior 2 " + AMBER) + "rotate 30*y }"),
    fading("prism_other_way", "prism { linear_spline 0, 1.5, 5, <-1, -1>, <-1, 0.5>, <1, 1>, <1, -1>, <-1, -1> " + GLASS + "rotate 20*y scale 0.8 translate 0.1*y }"),
    fading("lathe", "lathe { linear_spline 5, <0, 0.1>, <0.9, 0.3>, <0.5, 1>, <0.7, 1.7>, <0, 1.8> " + GLASS + "}"),
    fading("plane", "plane { y, 0.5 " + clear("ior 1.33 " + AMBER, "rgbf <0.9, 0.95, 1, 0.95>") + "}"),
    fading("ball_in_water", "plane { y, 0.5 " + clear("ior 1.33 fade_distance 2 fade_power 1000") + "} sphere { <0, 0.6, -1>, 0.5 " + GLASS + "}"),
    fading("opaque_inside", BALL + GLASS + "} sphere { <0.2, 1, 0>, 0.4 pigment { rgb <0.3, 0.5, 0.9> } finish { ambient 0.3 diffuse 0.6 } }"),
    fading("clipped", BALL + "clipped_by { plane { y, 1.3 } } " + GLASS + "}"),
    fading("union_apart", "union { sphere { <-0.8, 1, 0>, 0.7 } sphere { <0.8, 1, 0>, 0.6 } " + GLASS + "}"),
    fading("nested", BALL + GLASS + "} sphere { <0.1, 1, 0>, 0.5 " + clear("ior 1.1 fade_distance 0.3 fade_power 2") + "}"),
    fading("overlapping", "sphere { <-0.3, 1, 0>, 0.7 " + GLASS + "} sphere { <0.4, 1, 0>, 0.6 " + clear() + "}"),
    fading("camera_inside", "sphere { <0, 1.5, -5>, 2.2 " + clear("fade_distance 3 fade_power 1") + "}"),
    *[caustics(f"sphere_{c}".replace(".", "_"), BALL + clear(f"ior 1.5 caustics {c}", "rgbf <0.5, 0.8, 0.6, 0.7>") + "}") for c in (0, 0.001, 0.02, 0.1, 0.5, 1, 3)],
    caustics("without_ior", BALL + clear("caustics 0.1", "rgbt <0.5, 0.8, 0.6, 0.4>") + "}"),
    caustics("box", BOX + clear("ior 1.3 caustics 0.05", "rgbft <0.5, 0.8, 0.6, 0.3, 0.3>") + "rotate 30*y }"),
    caustics("scaled", BALL + clear("caustics 0.04", "rgbf <0.5, 0.8, 0.6, 0.7>") + "scale <1, 0.5, 1.4> rotate 20*z }"),
    caustics("fading", BALL + clear("ior 1.4 caustics 0.04 " + AMBER, "rgbf <0.9, 0.9, 0.9, 0.9>") + "}"),
    caustics("inside", "sphere { <0, 0.5, 0>, 1.2 " + clear("caustics 0.04", "rgbf 0.7") + "} sphere { <0, 0.5, 0>, 0.5 pigment { rgb <0.3, 0.5, 0.9> } }"),
    caustics("two", BALL + clear("caustics 0.04", "rgbf 0.8") + "} " + "disc { <0.5, 2.4, -1>, <0.3, 1, -0.2>, 1 " + clear("caustics 0.1", "rgbf <1, 0.7, 0.4, 0.8>") + "}"),
    caustics("smooth_mesh", "mesh { " + " ".join(
        f"smooth_triangle {{ <{x}, 1.2, 0.8>, <0, 1, 0.3>, <{x + 0.9}, 1.4, 0.7>, <0.3, 1, 0.3>, <{x + 0.4}, 1.1, -0.7>, <0.1, 1, -0.4> }}" for x in (-1, -0.1)) + " "
        + clear("caustics 0.2", "rgbf <0.8, 0.9, 1, 0.8>") + "}"),
    caustics("picture", BALL + "pigment { checker rgbt <1, 1, 1, 0.7> rgbt <1, 0.3, 0.2, 0.5> scale 0.3 } finish { ambient 0 diffuse 0.2 } interior { ior 1.2 caustics 0.05 } }"),
    fading("in_fog", "fog { distance 12 rgb <0.7, 0.8, 0.9> } " + BALL + GLASS + "}"),
]
