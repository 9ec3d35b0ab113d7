# SPDX-License-Identifier: Apache-2.0
"""The rules of finishes: what surfaces make of light, in POV-Ray and Tachyon. The scenes are those of lights.py, with a finish for
each of the balls."""
from lights import (BALLS, EYE, FLOOR, FORWARD, TACHYON_AMBIENT, TACHYON_DIFFUSE, Rule, paren, plain,
                    tachyon_camera, tachyon_frame, vec)

# A light at the eye's side gives highlights in the balls' middle, one behind them gives grazing light.
LIGHTS = [((-2, 5, -3), (1, 0.9, 0.8)), ((5, 3, 4), (0.4, 0.5, 0.7))]
FLOOR_FINISH = ("ambient 0.1 diffuse 0.7", "ambient = 0.1  diffuse = 0.7")


def pov_finish(name, finishes, head="#version 3.6;\n", own_head="", floor=FLOOR_FINISH, lights=None, ambient=(1, 1, 1)):
    """finishes: of the two balls, in both languages."""
    lights = LIGHTS if lights is None else lights
    peer = head + (f"camera {{ location {vec(EYE)} direction {vec(FORWARD)} right <4/3, 0, 0> up <0, 1, 0> }}\n"
                   f"plane {{ y, 0 pigment {{ rgb {vec(FLOOR)} }} finish {{ {floor[0]} }} }}\n")
    own = own_head + ("conventions { mirror = add  limit = drop  min_weight = 0.00392156862745098 }\n"
                      "render { shading = blinn-phong  reflections = 4 }\n"
                      f"camera {{ position = {paren(EYE)}  right = {paren((4 / 3, 0, 0))}  up = (0, 1, 0)  "
                      f"forward = {paren(FORWARD)} }}\n"
                      f"light {{ type = ambient  color = {paren(ambient)} }}\n"
                      f"plane {{ point = (0, 0, 0)  normal = (0, 1, 0)  color = {paren(FLOOR)}  {floor[1]} }}\n")
    for (center, radius, color), (pov, keys) in zip(BALLS, finishes):
        peer += f"sphere {{ {vec(center)}, {radius} pigment {{ rgb {vec(color)} }} finish {{ {pov} }} }}\n"
        own += f"sphere {{ center = {paren(center)}  radius = {radius}  color = {paren(color)}  {keys} }}\n"
    for position, color in lights:
        peer += f"light_source {{ {vec(position)} color rgb {vec(color)} }}\n"
        own += f"light {{ position = {paren(position)}  color = {paren(color)} }}\n"
    return Rule(name, "povray", peer, own)


def highlight(s, roughness):
    return f"specular_color = ({s}, {s}, {s})  shininess = {1 / roughness:.17g}"


BASE = "ambient 0.1 diffuse 0.6", "ambient = 0.1  diffuse = 0.6"


def base(pov, own):
    return f"{BASE[0]} {pov}", f"{BASE[1]}  {own}"


# Tachyon: see lights.py.

def tachyon_finish(name, textures, lights, flags=(), render="shading = blinn-phong", specular=(0, 0)):
    """textures: of the two balls: what follows Opacity, and the keys of .glint. lights: in both languages."""
    def texture(color, phong, mirror=0):
        return (f"Texture Ambient {TACHYON_AMBIENT} Diffuse {TACHYON_DIFFUSE} Specular {mirror} Opacity 1 "
                f"{phong} Color {plain(color)} TexFunc 0")
    surface = f"ambient = {TACHYON_AMBIENT}  diffuse = {TACHYON_DIFFUSE}"
    peer = tachyon_camera() + f"Plane Center 0 0 0 Normal 0 1 0 {texture(FLOOR, 'Phong Plastic 0 Phong_size 30')}\n"
    own = ("conventions { pixel_sample = top_right  rounding = down  "
           "spot_falloff = linear  clamp_attenuation = false  attenuate_highlights = false  "
           "light_threshold = 0.001959  mirror = add  limit = drop }\n"
           f"render {{ {render} }}\n{tachyon_frame()}light {{ type = ambient }}\n"
           f"plane {{ point = (0, 0, 0)  normal = (0, 1, 0)  color = {paren(FLOOR)}  {surface} }}\n")
    for (center, radius, color), (phong, keys), mirror in zip(BALLS, textures, specular):
        peer += f"Sphere Center {plain(center)} Rad {radius} {texture(color, phong, mirror)}\n"
        own += (f"sphere {{ center = {paren(center)}  radius = {radius}  color = {paren(color)}  {surface}  {keys}  "
                f"mirror = {mirror} }}\n")
    return Rule(name, "tachyon", peer + lights[0] + "End_Scene\n", own + lights[1], flags=flags)


PLASTIC = "Phong Plastic 0.6 Phong_size 20", "specular_color = (0.6, 0.6, 0.6)  shininess = 20"


def metal(color):
    return ("Phong Metal 0.7 Phong_size 12",
            f"specular_color = {paren([0.7 * c for c in color])}  shininess = 12  tinted_highlight = false")


POINT = ("Light Center -2 5 -3 Rad 0.01 Color 0.9 0.8 0.5\n", "light { position = (-2, 5, -3)  color = (0.9, 0.8, 0.5) }\n")
FADING = ("Light Center -1 2.5 -3 Rad 0.01 Attenuation Constant 0.5 Linear 0 Quadratic 0.1 Color 0.9 0.8 0.5\n",
          "light { position = (-1, 2.5, -3)  color = (0.9, 0.8, 0.5)  attenuation = (0.5, 0, 0.1) }\n")
SPOT = ("SpotLight Center -2 5 -3 Rad 0.01 Direction 2.3 -5 3 Falloff_Start 5 Falloff_End 25 Color 0.9 0.8 0.5\n",
        "light { type = spot  position = (-2, 5, -3)  axis = (2.3, -5, 3)  inner_angle = 5  outer_angle = 25  "
        "color = (0.9, 0.8, 0.5) }\n")
# Bright, but so far that it counts on a part of the floor only.
FAINT = ("Light Center 0 4 -2 Rad 0.01 Attenuation Constant 0 Linear 0 Quadratic 15 Color 150 150 150\n",
         "light { position = (0, 4, -2)  color = (150, 150, 150)  attenuation = (0, 0, 15) }\n")

RULES = [
    pov_finish("pov_emission", [base("emission 0.5", "emission = 0.5"), base("emission rgb <0.3, 0.1, 0>", "emission_color = (0.09, 0.06, 0)")],
               head="#version 3.6;\n"),
    pov_finish("pov_ambient_light", [base("", ""), ("ambient rgb <0.2, 0.5, 0.1> diffuse 0.4", "ambient_color = (0.06, 0.3, 0.09)  diffuse = 0.4")],
               head="#version 3.6;\nglobal_settings { ambient_light rgb <0.8, 1, 1.2> }\n", ambient=(0.8, 1, 1.2)),
    pov_finish("pov_brilliance", [base("brilliance 3", "brilliance = 3"), base("brilliance 0.4", "brilliance = 0.4")]),
    pov_finish("pov_metallic", [base("specular 0.8 roughness 0.05 metallic", f"{highlight(0.8, 0.05)}  metallic = 1"),
                                base("phong 0.7 phong_size 12 metallic 0.6",
                                     "phong_color = (0.7, 0.7, 0.7)  phong_shininess = 12  metallic = 0.6")]),
    pov_finish("pov_two_highlights", [base("phong 0.4 phong_size 8 specular 0.5 roughness 0.01",
                                           f"phong_color = (0.4, 0.4, 0.4)  phong_shininess = 8  {highlight(0.5, 0.01)}"),
                                      base("phong 0.5", "phong_color = (0.5, 0.5, 0.5)")],
               floor=("ambient 0.1 diffuse 0.7 phong 0.3 phong_size 8 specular 0.5 roughness 0.01",
                      f"ambient = 0.1  diffuse = 0.7  phong_color = (0.3, 0.3, 0.3)  phong_shininess = 8  {highlight(0.5, 0.01)}")),
    pov_finish("pov_albedo", [base("diffuse albedo 0.3 brilliance 2 phong albedo 0.03 phong_size 20",
                                   "diffuse = 0.45  brilliance = 2  phong_color = (0.315, 0.315, 0.315)  phong_shininess = 20"),
                              base("specular albedo 0.1 roughness 0.05", highlight(0.1 * 22 / (8 - 4 / 1024), 0.05))],
               floor=("ambient 0.1 diffuse albedo 0.7 specular albedo 0.2 roughness 0.5",
                      f"ambient = 0.1  diffuse = 0.7  {highlight(0.4 / 3, 0.5)}")),
    pov_finish("pov_reflection", [base("reflection 0.5", "mirror = 0.5"),
                                  base("reflection 0.4 metallic", "mirror = 0.4  metallic = 1")]),
    pov_finish("pov_reflection_angle", [base("reflection { 0.05, 0.8 falloff 2 }", "mirror_min = 0.05  mirror = 0.8  mirror_falloff = 2"),
                                        base("reflection { 0.1, 0.6 }", "mirror_min = 0.1  mirror = 0.6  mirror_falloff = 1")],
               floor=("ambient 0.1 diffuse 0.5 reflection { 0, 0.9 falloff 5 }",
                      "ambient = 0.1  diffuse = 0.5  mirror = 0.9  mirror_falloff = 5")),
    pov_finish("pov_reflection_metallic", [base("reflection { 0.7 metallic }", "mirror = 0.7  mirror_metallic = 1"),
                                           base("reflection { 0.2, 0.9 falloff 1.5 metallic 0.5 }",
                                                "mirror_min = 0.2  mirror = 0.9  mirror_falloff = 1.5  mirror_metallic = 0.5")]),
    # ASE's ase2, and F_MetalC of metals.inc.
    pov_finish("pov_metals", [("ambient 0.05 brilliance 3 diffuse 0.6 metallic specular 0.7 roughness 0.04 reflection 0.15",
                               f"ambient = 0.05  brilliance = 3  diffuse = 0.6  metallic = 1  {highlight(0.7, 0.04)}  mirror = 0.15"),
                              ("ambient 0.25 brilliance 4 diffuse 0.5 metallic specular 0.8 roughness 1/80 reflection 0.5",
                               f"ambient = 0.25  brilliance = 4  diffuse = 0.5  metallic = 1  {highlight(0.8, 1 / 80)}  mirror = 0.5")]),
    tachyon_finish("tachyon_plastic", [PLASTIC, PLASTIC], POINT),
    tachyon_finish("tachyon_outline",
                   [("Outline 1 Outline_Width 0.3 Phong Plastic 0.6 Phong_size 20", PLASTIC[1] + "  outline = 1  outline_width = 0.3"),
                    ("Outline 0.5 Outline_Width 0.9 Phong Plastic 0.6 Phong_size 20", PLASTIC[1] + "  outline = 0.5  outline_width = 0.9")],
                   POINT),
    tachyon_finish("tachyon_metal", [metal(BALLS[0][2]), metal(BALLS[1][2])], POINT),
    tachyon_finish("tachyon_highlight_attenuation", [PLASTIC, metal(BALLS[1][2])], FADING),
    tachyon_finish("tachyon_highlight_spot", [PLASTIC, PLASTIC], SPOT),
    tachyon_finish("tachyon_faint_light", [PLASTIC, PLASTIC], FAINT),
    tachyon_finish("tachyon_phong", [PLASTIC, metal(BALLS[1][2])], POINT, flags=("-shade_phong",), render="shading = phong"),
    tachyon_finish("tachyon_no_highlight", [("Phong Plastic 0.6 Phong_size 20", ""), ("Phong Plastic 0.6 Phong_size 20", "")], POINT,
                   flags=("-shade_nullphong",), render="shading = diffuse"),
    tachyon_finish("tachyon_medium", [PLASTIC, PLASTIC], POINT, flags=("-mediumshade",),
                   render="shading = blinn-phong  shadows = false"),
    tachyon_finish("tachyon_mirror", [PLASTIC, PLASTIC], POINT, specular=(0.5, 0.3)),
]
