# SPDX-License-Identifier: Apache-2.0
"""Patterns of colors in POV-Ray's scenes, which glint reads as they are."""
from lights import Rule

FINISH = "finish { ambient 0.4 diffuse 0.6 phong 0.3 phong_size 20 }"
HEAD = ("#version 3.7; global_settings { assumed_gamma 1 }\n"
        "camera { location <0.6, 1, -4> look_at <0, 0.3, 0> angle 50 }\n"
        "light_source { <2, 3, -5>, rgb 1 }\n")
FLOOR = "plane { y, -1 pigment { rgb <0.2, 0.4, 0.6> } }\n"
BALL = "sphere { 0, 1 %s }\n"
MAP = "color_map { [0 rgb <0.9, 0.2, 0.1>] [0.3 rgb <0.1, 0.6, 0.2>] [0.3 rgb <0.2, 0.3, 0.9>] [0.8 rgb <1, 0.9, 0.3>] }"
PLACE = "scale <0.4, 0.5, 0.6> rotate <20, 0, 40> translate <0.2, 0.1, 0.3>"


def rule(name, objects):
    return Rule("pattern_" + name, "povray", HEAD + objects, "")


def pigment(pattern, after=""):
    return f"pigment {{ {pattern} {after} }} {FINISH}"


def mapped(pattern, after=PLACE):
    return pigment(f"{pattern} {MAP}", after)


def sky(name, items):
    return rule(name, BALL % "pigment { rgb 0.5 } finish { ambient 0 diffuse 0.2 reflection 0.7 }" + f"sky_sphere {{ {items} }}\n")


# A border of the pattern in a surface: its side there is within 1e-10.
CHECKER = "checker rgb <0.9, 0.2, 0.1> rgb <0.2, 0.3, 0.9>"
# A mesh with u and v, of two faces.
MESH = ("mesh2 { vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0.4>, <-1, 1, 0.4> }\n"
        "uv_vectors { 4, <0, 0>, <2, 0>, <2, 1>, <-0.2, 1> } face_indices { 2, <0, 1, 2>, <0, 2, 3> } %s }\n")


def on_uv(name, pattern, after="scale <0.4, 0.3, 1> rotate 20*z translate <0.05, 0.1, 0>"):
    return rule("uv_" + name, MESH % (pigment("uv_mapping " + pattern, after)))


RULES = [
    on_uv("checker", CHECKER),
    on_uv("checker_turned", CHECKER, "scale 0.4 rotate <30, 50, 20> translate 0.1"),
    *[on_uv(name.split()[0], f"{name} {MAP}") for name in (
        "gradient <1, 2, 0>", "onion", "wood", "marble", "radial", "spherical", "cylindrical", "planar", "boxed", "leopard", "spiral1 3")],
    *[on_uv(f"radial_{i}", f"radial {items} {MAP}") for i, items in enumerate(("frequency 3", "frequency 2 phase 0.3", "triangle_wave"))],
    on_uv("hexagon", "hexagon rgb <0.9, 0.2, 0.1> rgb <0.2, 0.3, 0.9> rgb 1", "rotate 90*x scale 0.1"),
    on_uv("brick", "brick rgb <0.9, 0.9, 0.8> rgb <0.8, 0.2, 0.1> brick_size <0.4, 0.2, 0.3> mortar 0.03", ""),
    on_uv("mandel", f"mandel 20 {MAP}", "translate <0.7, -0.5, 0> scale 0.7"),
    on_uv("frequency", f"gradient x frequency 3 phase 0.2 {MAP}"),
    on_uv("transmit", "checker rgbt <0.9, 0.2, 0.1, 0.6> rgb 0.8"),
    rule("uv_object", MESH % f"uv_mapping {pigment(CHECKER, 'scale 0.2')} rotate y*20"),
    rule("uv_texture", MESH % f"texture {{ uv_mapping {pigment(CHECKER, 'scale 0.2')} scale 0.5 }} rotate y*20"),
    rule("uv_in_union", "union { " + MESH % "" + f"uv_mapping {pigment(CHECKER, 'scale 0.2')} rotate y*20 }}\n"),
    rule("uv_layers", MESH % "texture { pigment { rgb <0.9, 0.8, 0.2> } } texture { pigment { uv_mapping checker rgbt 1 rgb <0.2, 0.3, 0.9> scale 0.2 } }"),
    rule("uv_both", f"#declare P = pigment {{ {CHECKER} scale 0.3 }}\n" + MESH % f"uv_mapping pigment {{ P }} {FINISH} translate 0.3*x"
         + MESH % f"pigment {{ P }} {FINISH} scale 0.5 translate <-0.7, 0, -1>"),
    rule("uv_list", "mesh2 { vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0.4>, <-1, 1, 0.4> } uv_vectors { 4, <0, 0>, <2, 0>, <2, 1>, <-0.2, 1> }\n"
         f"texture_list {{ 2, texture {{ uv_mapping {pigment(CHECKER, 'scale 0.3')} }} texture {{ {pigment(CHECKER, 'scale 0.3')} }} }} "
         "face_indices { 2, <0, 1, 2>, 0, <0, 2, 3>, 1 } }\n"),
    rule("checker", BALL % pigment(CHECKER, PLACE)),
    rule("checker_default", BALL % pigment("checker", PLACE)),
    rule("checker_one_pigment", BALL % pigment("checker pigment { rgb <0.9, 0.2, 0.1> }", PLACE)),
    rule("checker_one_texture", BALL % f"texture {{ checker texture {{ pigment {{ rgb <0.9, 0.2, 0.1> }} }} {PLACE} }}"),
    rule("hexagon_default_pigment", f"#default {{ {pigment('rgb <1, 0, 1>')} }}\n" + BALL % pigment("hexagon pigment { rgb <0.9, 0.2, 0.1> }", "scale 0.3")),
    rule("brick_one_pigment", BALL % pigment("brick pigment { rgb <0.9, 0.2, 0.1> }", "scale 0.06")),
    rule("checker_commas", BALL % pigment("checker color rgb <0.9, 0.2, 0.1>, color rgb 0.8", "scale 0.3")),
    rule("checker_names", "#declare A = rgb <0.9, 0.2, 0.1>; #declare B = color rgb 0.8;\n" + BALL % pigment("checker A B", "scale 0.3")),
    rule("checker_transmit", FLOOR + BALL % pigment("checker rgbt <0.9, 0.2, 0.1, 0.6> rgb 0.8", PLACE)),
    rule("checker_floor", "plane { y, 0 %s }\n" % pigment(CHECKER)),
    rule("checker_floor_lower", "plane { y, -1 %s }\n" % pigment(CHECKER, "scale 0.5")),
    rule("checker_box", "box { -1, 1 %s rotate y*30 }\n" % pigment(CHECKER, "translate 0.5")),
    rule("checker_moved", "union { sphere { <-0.5, 0, 0>, 0.7 } box { 0, 0.9 } %s scale 0.8 rotate <10, 20, 30> }\n" % pigment(CHECKER, "scale 0.3")),
    rule("checker_declared", f"#declare T = texture {{ {pigment(CHECKER, 'scale 0.2')} }}\n" +
         BALL % "texture { T rotate 30*z }" + "box { <1.1, 0, 0>, <1.8, 1, 1> texture { T scale 2 } }\n"),
    rule("checker_mirror", BALL % (f"pigment {{ {CHECKER} scale 0.4 }} finish {{ ambient 0.2 diffuse 0.5 reflection 0.3 }}") +
         "plane { y, -1 %s }\n" % pigment(CHECKER)),
    rule("gradient", BALL % mapped("gradient x")),
    rule("gradient_diagonal", BALL % mapped("gradient <1, 2, -3>")),
    rule("gradient_negative", BALL % mapped("gradient -y")),
    rule("gradient_frequency", BALL % mapped("gradient y frequency 3 phase 0.2")),
    rule("gradient_triangle", BALL % mapped("gradient y triangle_wave frequency 2 phase 0.1")),
    rule("gradient_transmit", FLOOR + BALL % pigment("gradient y color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgbt <0.1, 0.6, 0.9, 0.8>] }",
                                                     "scale 0.7")),
    rule("gradient_old_map", BALL % pigment("gradient y color_map { [0, 0.4 color rgb <0.9, 0.2, 0.1> color rgb 0.8]"
                                            " [0.4, 1 color rgb <0.1, 0.2, 0.9> color rgb y] }", "scale 0.7")),
    rule("onion", BALL % mapped("onion")),
    rule("onion_frequency", BALL % mapped("onion frequency 2 phase 0.3")),
    rule("wood", BALL % mapped("wood")),
    rule("wood_ramp", BALL % mapped("wood ramp_wave")),
    rule("marble", BALL % mapped("marble")),
    rule("radial", BALL % mapped("radial")),
    rule("radial_frequency", BALL % mapped("radial frequency 6")),
    *[rule(f"{name}_default", BALL % pigment(f"{word} {items}", PLACE)) for name, word, items in (
        ("wood", "wood", ""), ("marble", "marble", ""), ("radial", "radial", "frequency 3"), ("onion", "onion", ""),
        ("gradient", "gradient y", "triangle_wave"), ("mandel", "mandel 40", "scale 0.6"), ("leopard", "leopard", "scale 0.1"))],
    rule("default_kept", "#declare P = " + f"pigment {{ onion {MAP} }}\n" + BALL % pigment("P wood", PLACE)),
    rule("default_of_plain", "#declare P = pigment { rgb x }\n" + BALL % pigment("P marble", PLACE)),
    sky("sky_default", "pigment { gradient y }"),
    rule("spherical", BALL % mapped("spherical", "scale 1.3 translate 0.4*x")),
    rule("cylindrical", BALL % mapped("cylindrical", "rotate 20*z")),
    rule("planar", BALL % mapped("planar", "rotate 20*z")),
    rule("boxed", BALL % mapped("boxed", "scale 1.3 translate 0.4*x")),
    sky("sky_gradient", f"pigment {{ gradient y {MAP} }}"),
    sky("sky_one_period", f"pigment {{ gradient y {MAP} scale 2 translate -1 }}"),
    sky("sky_turned", f"pigment {{ gradient <1, 2, 0> {MAP} scale 0.3 rotate 30*z }} rotate <10, 20, 30>"),
    sky("sky_last_pigment", f"pigment {{ rgb x }} pigment {{ gradient y {MAP} }}"),
    sky("sky_planar", f"pigment {{ planar {MAP} }}"),
    sky("sky_planar_scaled", f"pigment {{ planar {MAP} scale 0.4 }} rotate 20*z"),
    rule("brick", BALL % pigment("brick", "scale 0.1")),
    rule("brick_colors", BALL % pigment("brick rgb <0.9, 0.2, 0.1>, rgb 0.8 brick_size <2, 1, 3> mortar 0.2", PLACE)),
    rule("brick_thick", FLOOR + BALL % pigment("brick rgb 1 rgbt <0.9, 0.2, 0.1, 0.6> brick_size 0.4 mortar 0.15", "rotate 30*y")),
    rule("brick_wall", "plane { -z, -0.5 %s }\nplane { y, -0.9 %s }\n" % (pigment("brick", "scale 0.1"), pigment("brick rgb x", "scale 0.2 translate 0.03"))),
    rule("hexagon", BALL % pigment("hexagon", "scale 0.2")),
    rule("hexagon_colors", BALL % pigment("hexagon rgb <0.9, 0.2, 0.1>, rgb 0.8 rgb <0.1, 0.3, 0.6>", PLACE)),
    rule("hexagon_floor", FLOOR.replace("-1", "-1.5") + "plane { y, -0.9 %s }\n" % pigment("hexagon rgb 0.3 rgb 0.9 rgb <1, 0.5, 0.2>", "scale 0.3 rotate 20*y")),
    rule("checker_pigments", BALL % pigment("checker pigment { rgb <0.9, 0.2, 0.1> } pigment { White } ".replace("White", "rgb 0.8"), PLACE)),
    rule("checker_textures", "#declare A = texture { pigment { rgb <0.9, 0.2, 0.1> } %s }\n" % FINISH +
         BALL % ("texture { checker texture { A } texture { pigment { rgb 0.8 } %s } %s }" % (FINISH, PLACE))),
    rule("checker_textures_moved", "#declare A = texture { pigment { rgb <0.9, 0.2, 0.1> } %s }\n" % FINISH +
         BALL % ("texture { checker texture { A } texture { A pigment { rgb 0.8 } } scale 0.3 } rotate 30*z scale 0.9")),
    rule("texture_map", BALL % ("texture { gradient y texture_map { [0.2 pigment { rgb <0.9, 0.2, 0.1> } %s] [0.7, pigment { rgb 0.8 } %s] } %s }"
                                % (FINISH, FINISH, PLACE))),
    rule("pigment_map", "#declare P = pigment { rgb <0.1, 0.6, 0.2> }\n" +
         BALL % pigment("onion pigment_map { [0 rgb <0.9, 0.2, 0.1>] [0.4 P] [0.4, color rgb 0.8] [1 P] }", PLACE)),
    *[rule(f"of_pattern_{name}", f"#declare P = pigment {{ onion {MAP} scale 0.3 rotate 50*z }}\n" + BALL % pigment(items, PLACE)) for name, items in (
        ("checker", "checker pigment { P } pigment { rgb 0.8 }"), ("brick", "brick pigment { rgb 0.8 } pigment { P } brick_size <1, 0.5, 1> mortar 0.1"),
        ("hexagon", "hexagon pigment { rgb x } pigment { P } pigment { P }"),
        ("gradient", "gradient y pigment_map { [0.1 P] [0.6 rgb <0.9, 0.2, 0.1>] [0.9 rgb <0.1, 0.2, 0.9>] }"),
        ("wood", "wood pigment_map { [0 rgb 0.8] [0.4 P] [0.8 rgb <0.9, 0.2, 0.1>] [1 P] } frequency 2 phase 0.3"))],
    rule("of_pattern_textures", "#declare A = texture { pigment { onion %s } %s scale 0.3 }\n" % (MAP, FINISH) +
         BALL % ("texture { checker texture { A } texture { pigment { rgb 0.8 } %s } %s }" % (FINISH, PLACE))),
    rule("of_pattern_texture_map", "#declare A = texture { pigment { onion %s } %s scale 0.3 }\n" % (MAP, FINISH) +
         BALL % ("texture { gradient y texture_map { [0.2 A] [0.8 pigment { rgb 0.8 } %s] } %s }" % (FINISH, PLACE))),
    rule("map_beyond_1", BALL % pigment("gradient y color_map { [-0.5 rgb <0.9, 0.2, 0.1>] [0.6 rgb 0.9] [1.7 rgb <0.1, 0.2, 0.9>] }", PLACE)),
    rule("map_of_one", BALL % pigment("gradient y color_map { [0.4 rgb <0.9, 0.2, 0.1>] [1.5 rgb <0.1, 0.2, 0.9>] } quick_color rgb x", PLACE)),
    rule("leopard", BALL % mapped("leopard", "scale 0.1")),
    rule("spiral", BALL % mapped("spiral1 3")),
    rule("spiral_ramp", BALL % mapped("spiral1 1 ramp_wave")),
    rule("spiral_backwards", BALL % mapped("spiral1 -2 frequency 2 phase 0.3")),
    rule("spiral_fraction", BALL % mapped("spiral1 -1.9 ramp_wave")),
    rule("spiral_without_arms", BALL % mapped("spiral1 0.4")),
    rule("spiral_disc", "disc { 0, z, 1.3 %s rotate <30, 20, 0> }\n" % mapped("spiral1 9", "scale 0.2")),
    rule("mandel", BALL % mapped("mandel 10", "scale 0.6 translate 0.3*x")),
    rule("mandel_placed", BALL % mapped("mandel 50.7")),
    rule("mandel_one", BALL % mapped("mandel 1", "scale 0.6")),
    rule("mandel_triangle", BALL % mapped("mandel 20 triangle_wave", "scale 0.6 translate 0.3*x")),
    rule("mandel_deep", "box { <-2, -2, 0>, <2, 2, 1> %s }\n" % mapped("mandel 200", "translate <0.7653, -0.1005, 0> scale 500")),
]
