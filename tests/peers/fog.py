# SPDX-License-Identifier: Apache-2.0
"""The rules of fog and depth cueing: one scene each, as in lights.py. The upper part of each picture shows the background."""
from lights import Rule, own_for_tachyon, paren, pov_light, plain, tachyon_scene, vec

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


RULES = [
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
