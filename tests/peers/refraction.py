# SPDX-License-Identifier: Apache-2.0
"""Refraction of transparent objects: of all kinds, solids and meshes, nested and overlapping, with total internal reflection."""
from pov import CAMERA, LIGHT, rule

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 12 }\n"
ROOM = ("plane { y, -0.01 pigment { checker rgb <1, 0.9, 0.8> rgb <0.2, 0.3, 0.2> } finish { ambient 0.2 diffuse 0.7 } }\n"
        "box { <-3, 0, 2.5>, <3, 2, 3> pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.3 diffuse 0.6 } }\n")


def glass(color, ior=1.5, kind="rgbf", more="finish { ambient 0 diffuse 0 }"):
    return f"pigment {{ {kind} {color} }} {more} interior {{ ior {ior} }}"


GREEN, VIOLET, PINK = glass("<0.6, 0.9, 0.7, 0.95>"), glass("<0.8, 0.6, 0.9, 0.9>"), glass("<0.95, 0.9, 0.9, 0.95>")
WATER, AIR = glass("<0.9, 1, 0.9, 0.95>", 1.2), "pigment { rgbf <0.9, 1, 0.9, 0.95> } finish { ambient 0 diffuse 0 }"
MESH = "".join(f"triangle {{ {a}, {b}, {c} }} " for a, b, c in (
    ("<-1, 0.1, -0.5>", "<1, 0.1, -0.5>", "<0, 1.8, 0>"), ("<-1, 0.1, -0.5>", "<0, 1.8, 0>", "<0, 0.1, 1>"),
    ("<1, 0.1, -0.5>", "<0, 0.1, 1>", "<0, 1.8, 0>"), ("<-1, 0.1, -0.5>", "<0, 0.1, 1>", "<1, 0.1, -0.5>")))
BALL, BOX = "sphere { <0, 1, 0>, 0.9 ", "box { <-0.9, 0.1, -0.6>, <0.9, 1.6, 0.6> "

# Closed shapes: what is before their material, and after it.
SHAPES = {
    "box": (BOX, "rotate 30*y }"),
    "cylinder": ("cylinder { <-1, 1, 0>, <1, 1, 0>, 0.7 ", "rotate 40*y }"),
    "cone": ("cone { <0, 0.01, 0>, 1, <0, 2, 0>, 0.2 ", "}"),
    "torus": ("torus { 0.8, 0.35 ", "rotate -40*x translate 0.9*y }"),
    "quadric": ("quadric { <1, 1, 2>, <0, 0, 0>, <0, 0, 0>, -0.6 ", "translate y }"),
    "sphere_sweep": ("sphere_sweep { linear_spline 3, <-0.8, 0.5, 0>, 0.3, <0, 1.3, 0>, 0.4, <0.8, 0.6, 0>, 0.2 ", "}"),
    "prism": ("prism { linear_spline 0, 1.5, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 0.5>, <-1, -1> ", "rotate 20*y scale 0.8 translate 0.1*y }"),
    "mesh": ("mesh { " + MESH, "rotate 20*y }"),
    "difference": ("difference { " + BALL + "} cylinder { <0, 1, -3>, <0, 1, 3>, 0.4 } ", "rotate 25*y }"),
    "merge": ("merge { sphere { <-0.3, 1, 0>, 0.7 } sphere { <0.4, 1, 0>, 0.6 } ", "}"),
}


def balls(first, second, inside=""):
    """A union of two, with these items of their finishes, and those of an interior of the second."""
    def ball(x, finish, interior):
        return f"sphere {{ <{x}, 1, 0>, 0.7 pigment {{ rgbf 0.9 }} finish {{ ambient 0 diffuse 0 {finish} }} {interior} }} "
    return "union { " + ball(-0.8, first, "") + ball(0.8, second, inside and f"interior {{ {inside} }}") + "}"


def refraction(name, objects, head=HEAD):
    return rule("refraction_" + name, ROOM + objects, head=head + CAMERA + LIGHT)


def fresnel(name, objects, more=""):
    return refraction("fresnel_" + name, objects + more)


def clear(reflection, ior=1.5, color="rgbf <0.95, 0.95, 0.9, 0.9>", more=""):
    return f"pigment {{ {color} }} finish {{ ambient 0 diffuse 0.1 phong 0.6 reflection {{ {reflection} }} {more} }} interior {{ ior {ior} }} "


# Mirrors by Fresnel's equations, of opaque and of transparent objects.
PAINT = "pigment { rgb <0.2, 0.3, 0.7> } finish { phong 0.6 "
FRESNEL = [
    fresnel("opaque", BALL + PAINT + "reflection { 0.8 fresnel } } interior { ior 1.5 } }"),
    fresnel("two_values", BALL + PAINT + "reflection { 0.1, 0.9 fresnel on falloff 3 } } interior { ior 2 } }"),
    fresnel("metallic", BALL + PAINT + "reflection { <0.1, 0.05, 0.02>, <1, 0.5, 0.2> fresnel metallic } } interior { ior 1.3 } }"),
    fresnel("off", BALL + PAINT + "reflection { 0.1, 0.9 fresnel off } } interior { ior 2 } }"),
    fresnel("kept", BALL + PAINT + "reflection { 0.1, 0.9 fresnel } reflection { 0.2, 0.6 } } interior { ior 2 } }"),
    fresnel("without_ior", BALL + PAINT + "reflection { 0.1, 0.9 fresnel } } }"),
    fresnel("camera_inside", "sphere { <0, 1.5, -5>, 2.2 " + PAINT + "reflection { 0.1, 0.9 fresnel } } interior { ior 1.2 } pigment { rgbt 0.9 } }"),
    fresnel("glass", BALL + clear("1 fresnel") + "}"),
    fresnel("dense", BOX + clear("1 fresnel", 2) + "rotate 30*y }"),
    fresnel("thin", BOX + clear("0.1, 0.9 fresnel", 0.8) + "rotate 30*y }"),
    fresnel("plane", "plane { y, 0.5 " + clear("1 fresnel", 1.33) + "}"),
    fresnel("opaque_in_water", "plane { y, 0.5 " + clear("1 fresnel", 1.33) + "} sphere { <0, 0.6, -1>, 0.4 pigment { rgb x } }"),
    *[fresnel(name, before + clear("0.9 fresnel", 1.4) + after) for name, (before, after) in SHAPES.items() if name in ("difference", "torus", "mesh")],
    fresnel("conserve", BALL + clear("0.1, 1 fresnel", more="conserve_energy") + "}"),
    refraction("conserve", BALL + clear("0.7", 1, "rgbt <0.9, 0.95, 1, 0.8>", "conserve_energy") + "}"),
    refraction("conserve_metallic", BALL + clear("0.1, 0.8 falloff 2 metallic", 1.2, "rgbf <0.9, 0.5, 0.3, 0.8>", "conserve_energy") + "}"),
]

RULES = FRESNEL + [
    refraction("sphere", BALL + GREEN + "}"),
    refraction("two_levels", BALL + GREEN + "}", HEAD.replace("12", "2")),
    refraction("own_light", BALL + glass("<0.6, 0.9, 0.7, 0.6>", 1.3, "rgbt", "finish { ambient 0.1 diffuse 0.6 phong 0.5 }") + "}"),
    refraction("mirror", BALL + glass("<0.9, 0.9, 1, 0.9>", 1.5, "rgbf", "finish { ambient 0 diffuse 0.1 reflection 0.2 phong 0.5 }") + "}"),
    *[refraction(name, before + (VIOLET if name in ("cylinder", "cone", "torus") else GREEN) + after)
      for name, (before, after) in SHAPES.items()],
    refraction("bubble", BOX + glass("<0.8, 0.9, 0.9, 0.9>", 0.8) + "rotate 30*y }"),
    refraction("mirror_box", BOX + glass("<0.8, 0.9, 0.9, 0.7>", 1.2, "rgbf", "finish { ambient 0 diffuse 0.2 reflection 0.2 }") + "rotate 30*y }"),
    refraction("disc", "disc { <0, 1, 0>, <0, 0.3, -1>, 0.8 " + VIOLET + "}"),
    refraction("triangle", "triangle { <-1, 0.1, -0.5>, <1, 0.1, -0.5>, <0, 1.8, 0> " + VIOLET + "}"),
    refraction("plane", "plane { y, 0.5 " + glass("<0.8, 0.9, 0.95, 0.9>", 1.33) + "}"),
    refraction("ball_in_water", "plane { y, 0.5 " + glass("<0.8, 0.9, 0.95, 0.9>", 1.33) + "} sphere { <0, 0.6, -1>, 0.5 " + PINK + "}"),
    refraction("half", "intersection { plane { y, 1.2 } " + BALL + "} " + GREEN + "}"),
    refraction("clipped", BALL + "clipped_by { plane { y, 1.3 } } " + GREEN + "}"),
    refraction("inverse", BALL + "inverse " + GREEN + "}"),
    refraction("union", "union { sphere { <-0.3, 1, 0>, 0.7 } sphere { <0.4, 1, 0>, 0.6 } " + GREEN + "}"),
    *[refraction(f"finish_{i}", balls(*items))
      for i, items in enumerate((("ior 1.4", ""), ("", "ior 1.4"), ("ior 1.2", "ior 1.4"), ("ior 1.4", "", "ior 1.2")))],
    refraction("nested", BALL + PINK + "} sphere { <0.1, 1, 0>, 0.5 " + WATER + "}"),
    refraction("air_inside", BALL + PINK + "} sphere { <0.1, 1, 0>, 0.5 " + AIR + "}"),
    refraction("overlapping", "sphere { <-0.3, 1, 0>, 0.7 " + PINK + "} sphere { <0.4, 1, 0>, 0.6 " + WATER + "}"),
    refraction("beside_opaque", "sphere { <-0.3, 1, 0>, 0.7 " + PINK + "} sphere { <0.4, 1, 0>, 0.6 pigment { rgb <0.9, 1, 0.9> } }"),
    *[refraction(f"plate_{i}", f"box {{ <-1, 0.3, 0>, <1, 1.6, {thick}> " + GREEN + "rotate 30*y }") for i, thick in enumerate((0.0002, 0.0006))],
    refraction("fog_before_wall", "fog { distance 40 rgb <0.8, 0.9, 1> } plane { z, 6 pigment { rgb <0.5, 0.4, 0.6> } } " + BALL + GREEN + "}"),
    refraction("wall_with_ior", "plane { z, 6 pigment { rgb <0.5, 0.4, 0.6> } interior { ior 1.2 } } " + BALL + GREEN + "}"),
    refraction("clear_before_wall_with_ior", "plane { z, 6 pigment { rgb 0.5 } interior { ior 1.5 } } " + BALL + AIR + "}"),
    refraction("camera_inside", "sphere { <0, 1.5, -5>, 2.2 " + PINK + "}"),
]
