# SPDX-License-Identifier: Apache-2.0
"""Scenes of POV-Ray's own, which glint reads as they are."""
from lights import Rule

CAMERA = "camera { location <0, 1, -4> look_at <0, 0.8, 0> angle 60 }\n"
LIGHT = "light_source { <2, 3, -5>, rgb 1 }\n"
FLOOR = "plane { y, -1 pigment { rgb <0.8, 0.7, 0.6> } }\n"
MAP = "color_map { [0 color rgb <1, 1, 0.6>] [1 rgb <0.1, 0.3, 0.9>] }"
NORMALS = "<-2, -1, -1>", "<3, -3, -3>", "<0, 0.5, -0.5>"
CORNERS = "<-1.5, 0, 0>", "<1.5, 0, 0>", "<0, 2, 0>"
SHINE = "pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 phong_size 30 }"
GLAZE = "pigment { rgb <0.2, 0.4, 0.9> filter 0.8 } finish { ambient 0.2 diffuse 0.4 }"


def rule(name, objects, head="#version 3.6;\n" + CAMERA + LIGHT):
    return Rule("pov_" + name, "povray", head + objects, "")


def camera(name, items, depth=0):
    """With a camera of these items, or without one; depth: the balls are moved by it."""
    balls = "".join(f"sphere {{ <{x}, 0, {z + depth}>, 0.9 pigment {{ rgb <0.9, 0.3, 0.2> }} finish {{ phong 0.7 }} }}\n"
                    for x, z in ((-1, 0), (1.2, 0.5)))
    return rule("camera_" + name, FLOOR + balls, head="#version 3.6;\n" + (items and f"camera {{ {items} }}\n") + LIGHT)


def sky(name, items):
    return rule("sky_" + name, f"sky_sphere {{ {items} }}\nsphere {{ y, 0.8 pigment {{ rgb 0.2 }} finish {{ reflection 0.6 }} }}\n")


def smooth(items):
    corners = ", ".join(f"{p}, {n}" for p, n in zip(CORNERS, NORMALS))
    return f"smooth_triangle {{ {corners} {items} }}"


def mesh2(transform=""):
    return (f"mesh2 {{ vertex_vectors {{ 3, {', '.join(CORNERS)} }} normal_vectors {{ 3, {', '.join(NORMALS)} }} "
            f"face_indices {{ 1, <0, 1, 2> }} {transform} {SHINE} }}\n")


# A fan of four faces, with textures that differ in color, and a gray one with highlights.
FAN = ("mesh2 {{ vertex_vectors {{ 5, <-1.5, 0, 0>, <0, 2, 0.4>, <1.5, 0, 0>, <0, -1, 0.5>, <0, 0.6, -0.6> }} {normals}\n"
       "texture_list {{ 4, {textures} }}\n"
       "face_indices {{ 4, {faces} }} {items} }}\n")
FAN_NORMALS = "normal_vectors { 5, <-1, 0, -1>, <0, 3, -1>, <0.5, 0, -1>, <0, -1, -1>, -z }"
BY_CORNER = "<0, 1, 4>, 0, 1, 2, <1, 2, 4>, 1, 3, 2, <2, 3, 4>, 3, 0, 2, <3, 0, 4>, 0, 0, 2"
BY_FACE = "<0, 1, 4>, 0, <1, 2, 4>, 1, <2, 3, 4>, 3, <3, 0, 4>, 2"


def fan(faces, finish, normals=FAN_NORMALS, items="", colors=("<0.9, 0.2, 0.1>", "<0.1, 0.8, 0.2>", "1", "<0.1, 0.3, 0.9>")):
    return FAN.format(normals=normals, faces=faces, items=items, textures=" ".join(
        f"texture {{ pigment {{ color rgb {c} }} finish {{ {finish} }} }}" for c in colors))


PHONG = "ambient 0.3 diffuse 0.5 specular 0.6 roughness 0.03 phong 0.3"
RULES = [
    rule("mesh_colors", fan(BY_CORNER, PHONG)),
    rule("mesh_colors_flat", FLOOR + fan(BY_CORNER, "ambient 0.2 diffuse 0.9", normals="")),
    rule("mesh_colors_metallic", fan(BY_CORNER, "phong 0.8 metallic brilliance 2 reflection { 0.3 metallic }")),
    rule("mesh_colors_scaled", fan(BY_CORNER, PHONG, items="scale <0.8, 1, 3> rotate 20*y")),
    rule("mesh_colors_transmit", FLOOR + fan(BY_CORNER, PHONG, colors=(
        "<0.9, 0.2, 0.1> transmit 0.4", "<0.1, 0.8, 0.2> transmit 0.4", "1 transmit 0.4", "0 transmit 0.4"))),
    rule("mesh_colors_emission", fan(BY_CORNER, "emission 0.4 diffuse 0.6"), head="#version 3.7;\n" + CAMERA + LIGHT),
    rule("mesh_colors_ambient", fan(BY_CORNER, "ambient <0.1, 0.5, 0.3>")),
    rule("mesh_textures", fan(BY_FACE, PHONG)),
    rule("mesh_copies", "#declare M = " + fan(BY_CORNER, PHONG) + "".join(
        f"object {{ M scale <0.4, {s}, 0.5> rotate {30 * s}*z translate <{s - 1.5}, {0.4 * s}, 0> }}\n" for s in (0.3, 0.8, 1.6, 2.3))),
    rule("mesh_single_faces", "".join(
        f"mesh2 {{ vertex_vectors {{ 3, <{x}, 0, 0>, <{x + 1}, 0, 0.3>, <{x}, 1.5, 0> }} normal_vectors {{ 3, <-1, 0, -2>, <1, 0, -1>, <0, 1, -2> }}\n"
        f"texture_list {{ 3, texture {{ pigment {{ rgb {c} }} }} texture {{ pigment {{ rgb 0.9 }} }} texture {{ pigment {{ rgb y }} }} }}\n"
        "face_indices { 1, <0, 1, 2>, 0, 1, 2 } }\n" for x, c in ((-2, "x"), (-0.8, "z"), (0.5, "<1, 1, 0>")))),
    sky("gradient", f"pigment {{ gradient y {MAP} }}"),
    sky("one_period", f"pigment {{ gradient y {MAP.replace('[0', '[0.3').replace('[1', '[0.8')} scale 2 translate -1 }}"),
    sky("turned", f"pigment {{ gradient <1, 2, 0> {MAP} scale 0.9 rotate 30*z }} rotate <10, 20, 30>"),
    sky("color", "pigment { rgb <0.3, 0.5, 0.7> }"),
    rule("logic", FLOOR + "#macro Ball(N, C) sphere { <mod(N, 6)*0.6 - 1.5, div(N, 6)*0.7 - 0.6, 0>, 0.28 "
         "pigment { rgb 0.2 + 0.6*C } } #end\n"
         "#declare A = array[8] { 1e-9, 1.1e-10, 1e-10, 1e-11, 0, -1e-11, -1e-9, 1 };\n"
         "#for (I, 0, 7) Ball(I, <(A[I] & 1), (A[I] | 0), (A[I] > 0)>) Ball(I + 8, <(A[I] < 0), (A[I] = 0), (A[I] >= 0)>) #end\n"
         "Ball(16, (<1, 0, 3> & <0, 2, 3>)) Ball(17, (<1, 0, 3> | <0, 0, 3>)) Ball(18, (<1, 0, 3> < <0, 2, 3>))\n"
         "Ball(19, <asin(2), acos(2), acos(-2)>/4) Ball(20, <asin(-2), acos(-1.1), 0>/4) Ball(21, !<1, 0, 1e-11>)\n"),
    rule("normals", smooth(SHINE)),
    rule("normals_scaled", smooth("scale <1, 1.2, 3> " + SHINE)),
    rule("normals_mesh", f"mesh {{ {smooth('')} scale <1, 1.2, 0.4> {SHINE} }}\n"),
    rule("normals_mesh2", mesh2()),
    rule("normals_mesh2_scaled", mesh2("scale <1, 1.2, 0.4>")),
    rule("looks_like", FLOOR + "light_source { <0, 1.5, 0>, rgb 0.7 looks_like { sphere { 0, 0.4 pigment { rgb 1 } "
         "finish { ambient 1 diffuse 0 } } } }\nsphere { <-1, 0, 0>, 0.6 pigment { rgb <1, 0.2, 0.2> } }\n"),
    rule("camera_down", "camera { location <1, 9, 1> look_at <1, 0, 1> angle 40 }\n" + LIGHT + FLOOR +
         "box { <1, 0, 2>, <2, 1, 4> pigment { rgb <0, 1, 0> } }\nsphere { 0, 1 pigment { rgb <1, 0, 0> } }\n", head=""),
    rule("spot_angles", FLOOR + "light_source { <-1, 2, 0>, rgb <1, 0, 0> spotlight point_at -x radius 40 falloff 20 }\n"
         "light_source { <1, 2, 0>, rgb <0, 1, 0> spotlight point_at x radius 60 }\n"
         "light_source { <0, 2, 2>, rgb <0, 0, 1> spotlight point_at 2*z radius -10 falloff -30 tightness 3 }\n",
         head="#version 3.6;\n" + CAMERA),
    rule("glass", FLOOR + "sphere { <-1, 0.5, 0>, 0.9 pigment { rgbf 1 } finish { phong 0.8 } interior { ior 1.5 } }\n"
         "cylinder { <-3, 0, 1.6>, <3, 0.5, 1.6>, 0.3 pigment { rgb <1, 0, 0> } }\n"),
    # Transparent faces that coincide, and some that are near each other, for what is seen and for shadows.
    rule("coinciding", FLOOR + f"box {{ <-1.2, 0, -0.5>, <0.2, 0.7, 0.9> {GLAZE} }}\n"
         f"mesh {{ triangle {{ <-1.2, 0.7, -0.5>, <0.2, 0.7, -0.5>, <0.2, 0.7, 0.9> }} {GLAZE} rotate 0 }}\n"
         f"cylinder {{ <-0.5, 0.7, 0.2>, <-0.5, 1, 0.2>, 0.4 {GLAZE} }}\n" +
         "".join(f"disc {{ <{x}, 0.8, 0.3>, <0.3, 0.5, -1>, 0.4 {GLAZE} }}\ndisc {{ <{x}, {0.8 + gap}, 0.3>, <0.3, 0.5, -1>, 0.4 {GLAZE} }}\n"
                 for x, gap in ((0.7, 0.00004), (1.5, 0.0006), (2.3, 0.006)))),
    rule("smooth_triangle_sides", FLOOR + "".join(
        f"smooth_triangle {{ <{x}, 0, 0>, {a}, <{x + 1.4}, 0, 0>, {b}, <{x + 0.7}, 1.8, 0>, <0, 0.2, -1> pigment {{ rgb <0.9, 0.6, 0.3> }} }}\n"
        for x, a, b in ((-2, "<-0.4, 0, -1>", "<0.4, 0, -1>"), (-0.4, "<-0.4, 0, 0.2>", "<0.4, 0, -1>"), (1.1, "<-0.4, 0, 1>", "<0.4, 0, 1>")))),
    rule("functions", "#declare A = 0.4; #declare Wave = function(x, y) { A*sin(3*x)*cos(2*y) + (x > 0)*0.3 } #declare A = 5;\n"
         "#declare Twice = function { 2*Wave(x, y) + z }\n" + FLOOR + "#for (I, -8, 8) sphere { <I/4, Wave(I/4, 0.3) + 0.5, Twice(I/4, 1, 0.5)>, 0.2 " + SHINE + " } #end\n"),
    # A concave polygon, one that is not closed, two parts, and one that is not flat and not drawn.
    rule("polygons", FLOOR + "".join(f"polygon {{ {points} {SHINE} rotate <20, {turn}, 0> translate {at} }}\n" for points, turn, at in (
        ("6, <-1, -1>, <1, -1>, <0.2, 0>, <1, 1>, <-1, 1>, <-1, -1>", 30, "<-1.4, 0.6, 0>"), ("4, <0, 0>, <1, 0>, <1.3, 1>, <0.2, 1.2>", -40, "<0.4, 1, 0>"),
        ("8, <0, 0>, <0.6, 0>, <0.3, 0.7>, <0, 0>, <0.8, 0>, <1.4, 0>, <1.1, 0.7>, <0.8, 0>", 10, "<0.2, 0, -0.5>"),
        ("5, <-2, 2, 0>, <2, 2, 0>, <2, 0, 0.001>, <-2, 0, 0>, <-2, 2, 0>", 0, "z")))),
    rule("trace", "#declare O = union { difference { box { -1, 1 rotate 30*y } sphere { -z, 0.8 } } torus { 1.3, 0.3 rotate 20*x translate 0.5*y } "
         "triangle { <-2, 0, 1>, <2, 0, 1>, <0, 2, 1> } quadric { <1, 2, 1>, 0, 0, -0.4 translate <1.5, 0, 0> } "
         "prism { bezier_spline 0, 0.5, 4, <-2, 0>, <-1, 3>, <-1, -3>, <-2, 0> } sphere { 0, 0.5 scale <1, 2, 0.7> translate -1.5*x } } #declare N = y;\n" + FLOOR +
         "#for (I, 0, 799) #declare P = trace(O, <0, 1.013, -4>, <mod(I, 40)/16 - 1.25, div(I, 40)/16 - 0.75, 1.3>, N);\n"
         "#if (vlength(N) > 0) sphere { P + 0.1*N, 0.05 pigment { rgb (N + 1)/2 } finish { ambient 0.5 } } #end #end\n"),
    rule("inside", "#declare O = difference { union { box { -1, 1 rotate 30*y } cone { 0, 1.5, 2*y, 0.2 } torus { 1.5, 0.4 } } sphere { -z, 0.8 scale <1, 2, 1> } "
         "cylinder { -2*x, 2*x, 0.3 } quadric { <1, 1, 0>, 0, 0, -0.02 } plane { y, -0.6 } rotate <20, 10, 0> }\n" + FLOOR +
         "#for (X, -2, 2, 0.2) #for (Y, -1, 2, 0.2) #for (Z, -1, 1, 0.23) #if (inside(O, <X, Y, Z> + 0.013)) sphere { <X, Y, Z>, 0.08 pigment { rgb <X, Y, Z>/2 + 0.5 } } #end #end #end #end\n"),
    rule("splines", "#declare S = spline { -1, <-2, 0, 0>, 0, <-1, 1.6, 0>, 0.8, <0, -0.5, 1>, 2, <1, 1.5, 0.3>, 2.2, <2, 0, 0> }\n" + FLOOR +
         "#for (T, -1.2, 2.4, 0.05) sphere { S(T), 0.1 pigment { rgb x } } sphere { S(T, quadratic_spline), 0.08 pigment { rgb y } }\n"
         "sphere { S(T, cubic_spline), 0.09 pigment { rgb z } } sphere { S(T, natural_spline), 0.08 pigment { rgb x + y } } #end\n"),
    rule("hues", '#include "colors.inc"\n' + FLOOR + "#for (I, 0, 29) #declare C = CHSL2RGB(<I*47 - 300, mod(I, 7)/6, I/29>); #declare D = CRGB2HSV(C);\n"
         "sphere { <mod(I, 6)*0.6 - 1.5, div(I, 6)*0.5 - 0.6, 0>, 0.25 pigment { color C } finish { ambient 0.3 } }\n"
         "sphere { <mod(I, 6)*0.6 - 1.5, div(I, 6)*0.5 - 0.6, 0.7>, 0.25 pigment { color CHSV2RGB(<D.red + 90, D.green/2, D.blue>) } } #end\n"
         "sphere { <2.2, 0, 0>, 0.4 pigment { rgb CH2RGB(CRGB2H(rgb <0.25, 0.75, 0.375>, 0.75, 0.5)) } }\n"),
    # Spellings that POV-Ray takes beside those of its documentation.
    rule("spellings", "declare P = pigment { rgb <0.9, 0.3, 0.2> }\n#declare B = sphere { 0, 0.7 texture { P finish { phong 0.5 } } }\n"
         "#declare M = mesh2 { vertex_vectors { 3, <-2, 0, 1>, <0, 2, 1>, <2, 0, 1> } face_indices { 1, <0, 1, 2> } }\n" + FLOOR +
         "sphere { B translate -x }\nmesh2 { M texture { P } }\nfog { distance 20 color color rgb <0.3, 0.5, 0.8> }\n"
         "sphere { <1, 0, 0>, 0.6 pigment { rgbt 1 } finish { ambient 0 diffuse 0 refraction 1 ior 1.5 } hollow }\n"),
    # The default `right` is 1.33.
    camera("right", "location <0, 1, -4> look_at <0, 0.8, 0>"),
    camera("right_angle", "location <0, 1, -4> look_at <0, 0.8, 0> angle 60"),
    camera("right_direction", "location <0, 1, -4> direction 1.5*z"),
    camera("right_orthographic", "orthographic location <0, 1, -4> look_at <0, 0.8, 0>"),
    camera("right_orthographic_angle", "orthographic location <0, 1, -4> look_at <0, 0.8, 0> angle 50"),
    camera("none", "", depth=4),
    rule("shadowless", FLOOR + "light_source { <-4, 3, -2>, rgb 0.5 }\nlight_source { <2, 3, -5>, rgb 0.7 parallel shadowless }\n"
         "light_source { <2, 3, -5>, rgb 0.5 shadowless }\nsphere { <-1, 0, 0>, 0.9 finish { specular 0.4 phong 0.7 metallic } " +
         "pigment { rgb <0.9, 0.3, 0.2> } }\n", head="#version 3.6;\n" + CAMERA),
    *[rule(f"area_spot_{name}", FLOOR + f"sphere {{ <0, 0.3, 0>, 0.7 {SHINE} }}\nlight_source {{ <-3, 4, -2>, rgb 1.5 spotlight "
           f"point_at <0.2, 0, 0> {items} }}\n", head="#version 3.6;\n" + CAMERA + "light_source { <2, 3, -5>, rgb 0.2 }\n")
      for name, items in (("wide", "radius 14 falloff 22 area_light 1.6*x, 1.6*z, 5, 5"), ("narrow", "radius 4 falloff 9 area_light 0.8*x, 0.8*y, 4, 3"),
                          ("tight", "radius 10 falloff 25 tightness 20 area_light x, z, 5, 5 adaptive 1"),
                          ("orient", "radius 12 falloff 20 area_light 1.2*x, 1.2*z, 5, 5 circular orient fade_distance 4 fade_power 2"),
                          ("one_sample", "radius 12 falloff 20 area_light 2*x, 2*z, 1, 1"),
                          ("scaled", "radius 12 falloff 20 area_light 1.2*x, 1.2*z, 4, 4 scale <1, 1.2, 0.8>"))],
    # The places of the samples hardly change their shadows.
    rule("jitter_far", "box { <-2, -1, -1>, <2, -0.8, 1> pigment { rgb <0.8, 0.7, 0.6> } }\nsphere { <0, 0.3, 0>, 0.7 " + SHINE + " }\n"
         "light_source { <-20, 30, -20>, rgb 1.2 area_light 0.58*x, 0.58*z, 3, 3 adaptive 1 jitter }\n", head="#version 3.6;\n" + CAMERA),
    *[rule(f"area_{name}", FLOOR + f"sphere {{ <0, 0.3, 0>, 0.7 {SHINE} }}\nlight_source {{ <-3, 4, -2>, rgb 1 {items} }}\n", head="#version 3.6;\n" + CAMERA)
      for name, items in (("every_sample", "area_light <3, 0, 0>, <0, 0, 3>, 5, 5"), ("adaptive_before", "adaptive 1 area_light <3, 0, 0>, <0, 0, 3>, 5, 5"))],
    # Rays meet nothing within 0.0001.
    rule("near_mirror", "plane { <1, 0, -1>, 0 pigment { rgb 0 } finish { reflection 1 } }\nplane { -x, -0.003 pigment { rgb <1, 0, 0> } "
         "finish { ambient 1 diffuse 0 } }\nsphere { <-0.002, 0.0015, -0.03>, 0.0006 pigment { gradient y scale 0.002 translate 0.0001*y } finish { ambient 1 diffuse 0 } }\nbackground { rgb <0, 0, 1> }\n", head="#version 3.6;\ncamera { location <0, 0, -0.1> look_at 0 angle 6 }\n" + LIGHT),
    rule("near_shadow", "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\ntriangle { <0.003, -1, -1>, <0.003, 1, -1>, <0.003, 0, 2> "
         "pigment { rgb <1, 0, 0> } finish { ambient 1 diffuse 0 } }\nsphere { <0.0019, 0.0006, -0.01>, 0.0003 pigment { gradient y scale 0.002 translate 0.0001*y } finish { ambient 1 diffuse 0 } }\n", head="#version 3.6;\ncamera { location <0.0025, 0, -0.1> look_at <0.0025, 0, 0> angle 2 }\n"
         "light_source { <1000, 0, -1000>, rgb 1 }\n"),
    rule("small_mirrors", "".join(f"sphere {{ <{x}, {y}, {z}>, 0.0024 pigment {{ rgb <0.9, 0.6, 0.3> }} finish {{ reflection 0.6 }} }}\n"
         for x, y, z in ((-0.0024, 0, 0), (0.0028, 0.0008, 0), (0, 0.004, 0.0012))) + "background { rgb <0.2, 0.3, 0.6> }\n",
         head="#version 3.6;\ncamera { location <0, 0.004, -0.016> look_at <0, 0.0016, 0> angle 50 }\n" + LIGHT),
    rule("mesh_without_uv", "mesh2 { vertex_vectors { 3, <-1, -1, 0>, <0, 2, 0>, <1, -1, 0> } uv_vectors { 0 } texture_list { 1, texture { pigment { rgb x } } } "
         "face_indices { 1, <0, 1, 2>, 0 } uv_indices { 1, <0, 0, 0> } }\n"),
    rule("jitter_without_shadows", "plane { y, -1 pigment { rgb <0.8, 0.7, 0.6> } no_shadow }\nsphere { <0, 0.3, 0>, 0.7 no_shadow " + SHINE + " }\n"
         "light_source { <-3, 4, -2>, rgb 1.2 area_light 2*x, 2*z, 3, 3 jitter }\n"
         "light_source { <3, 4, -2>, rgb 0.4 area_light 2*x, 2*z, 3, 3 jitter shadowless }\n", head="#version 3.6;\n" + CAMERA),
    rule("refraction_opaque", FLOOR + "sphere { <0, 0.3, 0>, 0.7 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 refraction 1.2 ior 1.4 } }\n"
         "sphere { <1.2, 0, 0>, 0.5 pigment { rgb x } finish { refraction 0 } }\n"),
    rule("conserve_energy", FLOOR + "sphere { <-1, 0, 0>, 0.9 pigment { rgb <0.3, 0.6, 0.9> } finish { phong 0.7 "
         "reflection { 0.1, 0.8 } conserve_energy } }\nsphere { <1, 0, 0>, 0.7 pigment { rgbt <1, 0.3, 0.2, 0.5> } "
         "finish { conserve_energy } }\n"),
]
