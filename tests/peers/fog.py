# SPDX-License-Identifier: Apache-2.0
"""The rules of fog and depth cueing: one scene each, as in lights.py. The upper part of each picture shows the background."""
from lights import EYE, FORWARD, Rule, own_for_tachyon, paren, pov_light, plain, tachyon_scene, vec

COLOR = (0.6, 0.7, 0.9)
LIGHT = ((-2, 5, -3), (1, 0.9, 0.8))


def pov_fog(name, peer, own, pov_balls=("", ""), own_balls=("", ""), head=""):
    rule = pov_light(*LIGHT, "", "", name, pov_balls=pov_balls, own_balls=own_balls)
    rule.peer += f"fog {{ fog_type 1 {peer} }}\n"
    rule.own = head + rule.own + f"fog {{ type = exp  {own} }}\n"
    return rule


def tachyon_fog(name, peer, own, conventions="", mode="", specular=0):
    """specular: that of the balls, which are then mirrors."""
    position, color = (-1, 2.5, -3), (0.9, 0.8, 1)
    scene = tachyon_scene(f"{mode}Light Center {plain(position)} Rad 0.01 Color {plain(color)}\n"
                          f"Fog {peer} Color {plain(COLOR)}\nBackground 0.3 0.2 0.1\n")
    text = own_for_tachyon(f"light {{ position = {paren(position)}  color = {paren(color)} }}\n"
                           f"background = (0.3, 0.2, 0.1)\nfog {{ {own}  color = {paren(COLOR)} }}\n", conventions)
    if specular:
        scene = "".join(line.replace("Specular 0", f"Specular {specular}") if line.startswith("Sphere") else line
                        for line in scene.splitlines(keepends=True))
        text = text.replace("  color = (0.9, 0.5", f"  mirror = {specular}  color = (0.9, 0.5").replace(
            "  color = (0.3, 0.6", f"  mirror = {specular}  color = (0.3, 0.6")
    return Rule(name, "tachyon", scene, text)


def pov_in_fog(name, objects, location=EYE, forward=FORWARD, camera=""):
    """Fog outside of objects; glint reads the file. Glow: the texture of opaque objects; Clear, Amber: of transparent ones."""
    return Rule(name, "povray", f"""#version 3.6;
camera {{ {camera} location {vec(location)} direction {vec(forward)} right <4/3, 0, 0> up <0, 1, 0> }}
light_source {{ <-2, 6, -3> rgb 1 }}
background {{ rgb <0.7, 0.2, 0.1> }}
fog {{ fog_type 1 distance 9 color rgbt <0.6, 0.7, 0.9, 0.1> }}
#declare Clear = texture {{ pigment {{ rgb <0.3, 0.8, 0.4> filter 0.3 transmit 0.5 }} finish {{ ambient 0.2 diffuse 0.5 }} }}
#declare Amber = texture {{ pigment {{ rgb <0.9, 0.7, 0.2> transmit 0.7 }} finish {{ ambient 0.2 diffuse 0.5 }} }}
#declare Glow = texture {{ pigment {{ rgb <0.8, 0.3, 0.2> }} finish {{ ambient 0.8 diffuse 0.2 }} }}
#declare Mirror = texture {{ pigment {{ rgb 0.1 }} finish {{ ambient 0.1 diffuse 0.1 reflection 0.8 }} }}
plane {{ y, -1 pigment {{ rgb <0.8, 0.8, 0.7> }} finish {{ ambient 0.2 diffuse 0.7 }} }}
sphere {{ <0.4, 0.6, 6>, 1.5 texture {{ Glow }} }}
{objects}
""", "")


def pov_on_ground(name, fog, objects=None, camera="", head=""):
    """Fog on the ground, over the balls of pov_in_fog; the sky and a mirror show it, too."""
    mirror = "disc { <0, 1, 4>, <-0.1, 0.1, -1>, 3 texture { Mirror } }"
    rule = pov_in_fog(name, balls() + mirror if objects is None else objects, camera=camera)
    rule.peer = head + rule.peer.replace("fog_type 1 distance 9", f"fog_type 2 distance 9 {fog}")
    return rule


def pov_filter_fog(name, fog):
    """A fog that tints what is behind it; the sky and a mirror show it, too."""
    rule = pov_on_ground("pov_fog_filter_" + name, "")
    rule.peer = rule.peer.replace("fog_type 2 distance 9  color rgbt <0.6, 0.7, 0.9, 0.1>", f"distance 9 {fog}")
    assert fog in rule.peer
    return rule


def pov_orthographic_in_fog(name, objects):
    """Some rays start below the floor, or in the objects."""
    rule = pov_in_fog(name, objects)
    head, rest = rule.peer.split("camera {")[0], rule.peer.split("\nlight_source", 1)[1]
    rule.peer = head + ("camera { orthographic location <0, 1, -7.5> look_at <0, 0.8, 0> right 6.7*x up 5*y }\nlight_source") + rest
    return rule


# A tetrahedron, one of its sides, and two sheets: corners and faces.
TETRAHEDRON = "mesh2 {{ vertex_vectors {{ 4, <-2, -0.5, -2>, <2, -0.5, -2>, <0, -0.3, 2>, <0, 2.4, -0.5> }} face_indices {{ {} }} {} }}"
CLOSED, OPEN = "4, <0, 1, 2>, <0, 1, 3>, <1, 2, 3>, <2, 0, 3>", "1, <0, 1, 3>"
TRIANGLE = "triangle {{ <-2, -0.5, {z}>, <2, -0.2, {z}>, <0.5, 2.6, {z}> texture {{ {texture} }} }}\n"
BALL = "sphere {{ <{x}, 0.7, {z}>, 1.3 {more} }}\n"


def balls(more="texture { Clear }", other="texture { Amber }"):
    return BALL.format(x=-0.7, z=-1, more=more) + BALL.format(x=0.6, z=0, more=other)


# Some contain the camera at their place, and some do not.
INSIDES = [
    ("ellipsoid", "quadric {{ <1, 2, 1>, <0.5, 0, 0>, 0, -9 translate {}"),
    ("hyperboloid", "quadric {{ <1, 1, -1>, 0, 0, -4 translate {}"),
    ("two_sheets", "quadric {{ <1, 1, -1>, 0, 0, 4 translate {}"),
    ("torus", "torus {{ 2, 1.2 rotate 90*x translate <2, 0.3, 0> translate {}"),
    ("shell", "difference {{ sphere {{ 0, 3 }} sphere {{ 0, 2.2 }} translate {}"),
    ("bite", "difference {{ sphere {{ 0, 3 }} sphere {{ <1, 0, 0>, 0.9 }} translate {}"),
    ("half", "intersection {{ sphere {{ <1, 0, 0>, 3 }} plane {{ y, 0.5 }} translate {}"),
    ("merge", "merge {{ box {{ <-3, -2, -1>, <-0.2, 2, 1> }} cylinder {{ <-1, 0, 0>, <2, 0.3, 1>, 0.7 }} translate {}"),
    ("union", "intersection {{ union {{ sphere {{ <1, 0, 0>, 1.5 }} sphere {{ <-1, 0, 0>, 1.5 }} }} box {{ -2, 2 }} translate {}"),
    ("inverse", "intersection {{ box {{ -3, 3 }} cone {{ <0, -1, 0>, 1, <0, 2, 0>, 0 inverse }} translate {}"),
    ("clipped", "sphere {{ 0, 3 clipped_by {{ plane {{ <0.3, 1, 0>, 0.5 }} }} translate {}"),
    ("clipped_away", "sphere {{ 0, 3 clipped_by {{ plane {{ <0.3, 1, 0>, -0.5 }} }} translate {}"),
]

RULES = [
    pov_in_fog("pov_fog_sphere", BALL.format(x=0, z=0, more="texture { Clear }")),
    pov_in_fog("pov_fog_sphere_hollow", BALL.format(x=0, z=0, more="texture { Clear } hollow")),
    pov_in_fog("pov_fog_spheres", balls()),
    *[pov_filter_fog(name, fog) for name, fog in (("whole", "color rgbf <0.6, 0.7, 0.9, 1>"), ("half", "color rgbf <0.6, 0.4, 0.9, 0.5>"),
                                                  ("transmit", "color rgbft <0.6, 0.4, 0.9, 0.4, 0.3>"),
                                                  ("ground", "fog_type 2 fog_offset 0.3 fog_alt 0.4 color rgbf <0.6, 0.7, 0.5, 0.7>"))],
    pov_in_fog("pov_fog_nested", balls() + "sphere { <-0.5, 0.7, -0.8>, 0.6 texture { Clear } }"),
    pov_in_fog("pov_fog_union", "union { " + balls() + "}"),
    pov_in_fog("pov_fog_union_interiors",
               "union { " + balls("texture { Clear } interior { ior 1 }") + "}"),
    pov_in_fog("pov_fog_union_hollow", "union { " + balls("texture { Clear } interior { ior 1 }") + "hollow }"),
    pov_in_fog("pov_fog_union_hollow_part", "union { " + balls("texture { Clear } hollow") + "}"),
    pov_in_fog("pov_fog_groups", "union { union { " + balls() + "} union { sphere { <0, 0.5, -3>, 0.5 texture { Clear } } } }"),
    pov_in_fog("pov_fog_triangle", TRIANGLE.format(z=-1, texture="Clear")),
    pov_in_fog("pov_fog_triangles", TRIANGLE.format(z=-1, texture="Clear") + TRIANGLE.format(z=1, texture="Amber")),
    pov_in_fog("pov_fog_mesh", TETRAHEDRON.format(CLOSED, "texture { Clear }")),
    pov_in_fog("pov_fog_mesh_open", TETRAHEDRON.format(OPEN, "texture { Clear }")),
    pov_in_fog("pov_fog_meshes", TETRAHEDRON.format(CLOSED, "texture { Clear }")
               + TETRAHEDRON.format(CLOSED, "texture { Clear } translate <0.5, 0.2, 1>")),
    pov_in_fog("pov_fog_solids", "cylinder { <-2, 0, -1>, <0, 1, 0>, 0.8 texture { Clear } }\n"
               "box { <0.4, -0.5, -1>, <1.8, 1, 1> texture { Amber } rotate 20*y }\n"
               "cone { <-0.5, -0.5, -3>, 0.6, <-0.5, 0.8, -3>, 0.1 texture { Clear } }"),
    pov_in_fog("pov_fog_open_cylinder", "cylinder { <-2, 0.5, -1>, <1, 1, 0>, 0.9 open texture { Clear } }"),
    pov_in_fog("pov_fog_disc", "disc { <0, 0.8, -1>, <0.2, 0.1, -1>, 1.4 texture { Amber } }"),
    pov_in_fog("pov_fog_mirrors", balls() + "disc { <0, 1, 4>, <-0.1, 0.1, -1>, 3 texture { Mirror } }"),
    pov_in_fog("pov_fog_mirror_in_sphere", "sphere { <0, 0.7, 0>, 1.5 texture { Clear } } sphere { <0, 0.7, 0>, 0.7 texture { Mirror } }"),
    pov_in_fog("pov_fog_glass", BALL.format(x=0, z=0, more="pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 }")),
    pov_in_fog("pov_fog_camera_inside", balls() + "sphere { <0, 3, -8>, 3 texture { Amber } }"),
    pov_in_fog("pov_fog_camera_in_two", balls() + "sphere { <0, 3, -8>, 3 texture { Amber } } box { <-3, 0, -9>, <3, 5.5, -3.5> texture { Clear } }"),
    *(pov_in_fog(f"pov_fog_camera_in_{name}", balls() + f"{shape.format('<0, 3, -8>')} texture {{ Amber }} }}") for name, shape in INSIDES),
    *(pov_orthographic_in_fog(f"pov_fog_orthographic_{name}", balls() + f"{shape.format('<0, 1.8, -7.5>')} texture {{ Amber }} }}")
      for name, shape in INSIDES),
    pov_orthographic_in_fog("pov_fog_orthographic", balls() + "sphere { <0, 1.8, -7.5>, 0.9 texture { Amber } }"),
    pov_in_fog("pov_fog_sky", balls() + "sphere { 0, 60 texture { Glow } }"),
    pov_in_fog("pov_fog_sky_hollow", balls() + "sphere { 0, 60 texture { Glow } hollow }"),
    pov_in_fog("pov_fog_water", balls() + "plane { y, 0.4 texture { Amber } }"),
    pov_in_fog("pov_fog_ceiling", balls() + "plane { y, 8 texture { Glow } }"),
    pov_in_fog("pov_fog_under_water", balls() + "plane { y, 5 texture { Amber } }"),
    pov_on_ground("pov_fog_ground", "fog_offset 0.5 fog_alt 0.7"),
    pov_on_ground("pov_fog_ground_thin", "fog_offset -2 fog_alt 3"),
    pov_on_ground("pov_fog_ground_above", "fog_offset 4 fog_alt 0.2"),
    pov_on_ground("pov_fog_ground_no_offset", "fog_alt 0.5"),
    pov_on_ground("pov_fog_ground_up", "fog_alt 0.5 up <1, 4, 1>"),
    pov_on_ground("pov_fog_ground_turned", "fog_alt 0.5 fog_offset 0.2 up <1, 4, 1> scale <1, 0.5, 1> rotate 20*z translate 3"),
    pov_on_ground("pov_fog_ground_up_last", "fog_alt 0.5 rotate 90*z up y"),
    pov_on_ground("pov_fog_ground_hollow", "fog_alt 0.8", balls("texture { Clear } hollow", "texture { Amber } hollow")),
    pov_on_ground("pov_fog_ground_triangles", "fog_alt 0.8", TRIANGLE.format(z=-1, texture="Clear") + TRIANGLE.format(z=1, texture="Amber")),
    pov_on_ground("pov_fog_ground_glass", "fog_alt 0.8",
                  BALL.format(x=0, z=0, more="pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 }")),
    pov_on_ground("pov_fog_ground_sky_sphere", "fog_offset 1 fog_alt 2", balls()
                  + "sky_sphere { pigment { gradient y color_map { [0 rgb 1] [0.3 rgb <0.8, 0.2, 0.1>] [1 rgb z] } } }"),
    pov_fog("pov_fog", f"distance 8 color rgb {vec(COLOR)}", f"density = 0.125  color = {paren(COLOR)}"),
    pov_fog("pov_fog_thick", f"distance 2.5 color rgb {vec(COLOR)}", f"density = 0.4  color = {paren(COLOR)}"),
    pov_fog("pov_fog_transmit", f"distance 8 color rgbt {vec((*COLOR, 0.3))}",
            f"density = 0.125  transmit = 0.3  color = {paren(COLOR)}"),
    pov_fog("pov_fog_in_mirrors", f"distance 8 color rgb {vec(COLOR)}", f"density = 0.125  color = {paren(COLOR)}",
            ("finish { reflection 0.5 }", "finish { reflection 0.3 }"), ("mirror = 0.5", "mirror = 0.3"),
            "conventions { mirror = add }\n"),
    tachyon_fog("tachyon_fog_linear", "Linear Start 6 End 15 Density 1", "type = linear  start = 6  end = 15"),
    tachyon_fog("tachyon_fog_exp", "Exp Start 2 End 50 Density 0.12", "type = exp  start = 2  density = 0.12"),
    tachyon_fog("tachyon_fog_exp2", "Exp2 Start 1 End 50 Density 0.1", "type = exp2  start = 1  density = 0.1"),
    tachyon_fog("tachyon_fog_in_mirrors", "Exp Start 0 End 50 Density 0.1", "type = exp  density = 0.1", "mirror = add",
                specular=0.4),
    tachyon_fog("tachyon_fog_vmd_linear", "Linear Start 4 End 60 Density 1", "type = linear  start = 4  end = 60",
                "fog_distance = depth  fog_background = false", "Shader_Mode Full Fog_VMD End_Shader_Mode\n"),
    tachyon_fog("tachyon_fog_vmd_exp2", "Exp2 Start 1 End 50 Density 0.1", "type = exp2  start = 1  density = 0.1",
                "fog_distance = depth  fog_background = false", "Shader_Mode Full Fog_VMD End_Shader_Mode\n"),
]
