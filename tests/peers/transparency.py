# SPDX-License-Identifier: Apache-2.0
"""The rules of transparency without refraction: filter and transmit of POV-Ray, Opacity of Tachyon."""
from lights import EYE, FORWARD, HEIGHT, WIDTH, Rule, paren, plain, vec

FLOOR, BALL = (0.8, 0.8, 0.7), (0.3, 0.6, 0.9)
LIGHT = (-2, 6, -3)
# Pieces: (kind, geometry, color, options). A disc: center, normal, radius. Two panes, a ball and a transparent ball.
PANE, PANE_2, PANE_3 = ((-1.4, 1.3, -1), (0.2, 0.3, -1), 1.1), ((-0.9, 1.5, -2), (0, 0, -1), 0.8), ((-1.2, 1, -3), (0.1, 0, -1), 0.7)
BUBBLE = ((1.1, 1.1, -1.2), 0.8)
BEHIND = ((-1.2, 0.8, 1.2), 0.8)
BACKGROUND = (0.1, 0.15, 0.3)


# POV-Ray

def pov_piece(geometry, color, filter=0, transmit=0, options="", reflection=0):
    center, *rest = geometry
    shape = (f"disc {{ {vec(center)}, {vec(rest[0])}, {rest[1]}" if len(rest) == 2 else f"sphere {{ {vec(center)}, {rest[0]}")
    return (f"{shape} pigment {{ rgb {vec(color)} filter {filter} transmit {transmit} }} finish {{ ambient 0.1 diffuse 0.7 phong 0.4 "
            f"phong_size 30 reflection {reflection} }} {options} }}\n")


def pov_scene(pieces, version="3.7", levels=5, light=""):
    text = f"#version {version};\nglobal_settings {{ assumed_gamma 1 max_trace_level {levels} }}\n"
    if version < "3.7":  # without gamma
        text = text.replace("assumed_gamma 1 ", "")
    text += (f"camera {{ location {vec(EYE)} direction {vec(FORWARD)} right <4/3, 0, 0> up <0, 1, 0> }}\n"
             f"background {{ rgb {vec(BACKGROUND)} }}\n"
             f"plane {{ y, 0 pigment {{ rgb {vec(FLOOR)} }} finish {{ ambient 0.1 diffuse 0.7 }} }}\n"
             f"light_source {{ {vec(LIGHT)} color rgb <1, 0.9, 0.8> {light} }}\n")
    return text + "".join(pieces)


def own_piece(geometry, color, filter=0, transmit=0, options="", reflection=0, highlight=0.4):
    center, *rest = geometry
    shape = (f"disc {{ center = {paren(center)}  normal = {paren(rest[0])}  radius = {rest[1]}" if len(rest) == 2
             else f"sphere {{ center = {paren(center)}  radius = {rest[0]}")
    surface = "ambient = 0.1  diffuse = 0.7  "
    if highlight:
        surface += f"specular_color = {paren([highlight] * 3)}  shininess = 30  "
    return (f"{shape}  color = {paren(color)}  {surface}filter = {filter}  transmit = {transmit}  mirror = {reflection}  "
            f"{options} }}\n")


def own_scene(pieces, conventions, levels, forward, right, up, shading="phong", light="", sky=""):
    text = (f"conventions {{ {conventions} }}\nrender {{ shading = {shading}  reflections = {levels - 1} }}\n"
            f"camera {{ position = {paren(EYE)}  right = {paren(right)}  up = {paren(up)}  forward = {paren(forward)} }}\n"
            f"background = {paren(BACKGROUND)}\n"
            f"light {{ type = ambient }}\n"
            f"plane {{ point = (0, 0, 0)  normal = (0, 1, 0)  color = {paren(FLOOR)}  ambient = 0.1  diffuse = 0.7 }}\n"
            f"light {{ position = {paren(LIGHT)}  color = (1, 0.9, 0.8)  {light} }}\n{sky}")
    return text + "".join(pieces)


def area(columns, rows, adaptive=None):
    """The further items of an area light, in both languages. adaptive: POV-Ray's level; None: every sample is traced."""
    pov = f"area_light <2.4, 0, 0>, <0, 0, 2.4>, {columns}, {rows}"
    own = f"type = parallelogram  side_u = (2.4, 0, 0)  side_v = (0, 0, 2.4)  samples_u = {columns}  samples_v = {rows}"
    return (pov, own) if adaptive is None else (f"{pov} adaptive {adaptive}", f"{own}  adaptive = {adaptive}")


def pov(name, *pieces, version="3.6", levels=5, light=("", "")):
    """pieces: geometry, color and keywords of pov_piece; own: of own_piece in place of options. light: as of area()."""
    opacity = "brightest" if version < "3.7" else "whole"
    peer = [pov_piece(g, c, **{k: v for k, v in o.items() if k != "own"}) for g, c, o in pieces]
    own = [own_piece(g, c, **{**{k: v for k, v in o.items() if k != "own"}, "options": o.get("own", "")}) for g, c, o in pieces]
    return Rule(name, "povray", pov_scene(peer, version, levels, light[0]),
                own_scene(own, f"mirror = add  limit = drop  transparency = highlights  opacity = {opacity}  area_shading = center  "
                               f"min_weight = {1 / 255:.17g}", levels, FORWARD, (4 / 3, 0, 0), (0, 1, 0), light=light[1]),
                args=() if version < "3.7" else ("--transfer", "srgb"))


# Tachyon

def tachyon_texture(color, opacity, mirror, highlight=0):
    return (f"Texture Ambient 0.1 Diffuse 0.7 Specular {mirror} Opacity {opacity} Phong Plastic {highlight} Phong_size 30 "
            f"Color {plain(color)} TexFunc 0\n")


def tachyon_piece(geometry, color, opacity=1, mirror=0, highlight=0):
    center, *rest = geometry
    shape = (f"Ring Center {plain(center)} Normal {plain(rest[0])} Inner 0 Outer {rest[1]} " if len(rest) == 2
             else f"Sphere Center {plain(center)} Rad {rest[0]} ")
    return shape + tachyon_texture(color, opacity, mirror, highlight)


def tachyon(name, *pieces, mode="", depth=20, conventions="", sky=""):
    """mode: of Shader_Mode. conventions, sky: those that the mode changes."""
    length = sum(f * f for f in FORWARD) ** 0.5
    forward = [f / length for f in FORWARD]
    up, right = (0, forward[2], -forward[1]), (4 / 3, 0, 0)
    moved = [f + r * 0.5 / WIDTH + u * 0.5 / HEIGHT for f, r, u in zip(forward, right, up)]
    peer = (f"Begin_Scene\nResolution {WIDTH} {HEIGHT}\n"
            + (f"Shader_Mode Full {mode} End_Shader_Mode\n" if mode else "")
            + f"Camera Zoom 1 Aspectratio 1 Antialiasing 0 Raydepth {depth}\n"
            f"  Center {plain(EYE)} Viewdir {plain(forward)} Updir 0 1 0\nEnd_Camera\n"
            f"Background {plain(BACKGROUND)}\n"
            f"Light Center {plain(LIGHT)} Rad 0.01 Color 1 0.9 0.8\n"
            f"Plane Center 0 0 0 Normal 0 1 0 {tachyon_texture(FLOOR, 1, 0)}"
            + "".join(tachyon_piece(g, c, **o) for g, c, o in pieces) + "End_Scene\n")
    own = [own_piece(g, c, transmit=round(1 - o.get("opacity", 1), 9), reflection=o.get("mirror", 0), highlight=o.get("highlight", 0))
           for g, c, o in pieces]
    rules = "mirror = add  limit = background  transparency_counts = true  "
    return Rule(name, "tachyon", peer,
                own_scene(own, rules + (conventions or "transparency = add"), depth, moved, right, up, "blinn-phong", sky=sky))


RED, GREEN, AMBER = (0.9, 0.25, 0.2), (0.3, 0.8, 0.4), (0.9, 0.7, 0.2)
OPAQUE = (BEHIND, BALL, {})
PANES = [(PANE, RED, {"filter": 0.7}), (PANE_2, GREEN, {"filter": 0.4, "transmit": 0.3}), (PANE_3, AMBER, {"transmit": 0.6})]
# Twelve discs behind each other.
STACK = [((-1 + 0.1 * i, 1.6, -3 + 0.3 * i), (0, 0.2, -1), 0.9) for i in range(12)]
TWELVE = [(g, (0.9, 0.3 + 0.05 * i, 0.2), {"filter": 0.5, "transmit": 0.4}) for i, g in enumerate(STACK)]
CLEAR = [(PANE, RED, {"opacity": 0.4}), (PANE_2, GREEN, {"opacity": 0.6}), (PANE_3, AMBER, {"opacity": 0.25})]
RINGS = [(g, (0.9, 0.3 + 0.05 * i, 0.2), {"opacity": 0.25}) for i, g in enumerate(STACK)]
GLASS_BALL = (BUBBLE, AMBER, {"opacity": 0.4})

OCCLUSION = {"mode": "Ambient_Occlusion Ambient_Color 0.8 0.9 1 Rescale_Direct 0.4 Samples 24",
             "sky": "occlusion { method = fixed  samples = 24  color = (0.8, 0.9, 1)  direct = 0.4 }\n"}

RULES = [
    pov("pov_filter", (PANE, RED, {"filter": 0.8}), OPAQUE),
    pov("pov_transmit", (PANE, RED, {"transmit": 0.6}), OPAQUE),
    pov("pov_filter_transmit", *PANES, OPAQUE),
    pov("pov_filter_37", *PANES, OPAQUE, version="3.7"),
    pov("pov_twelve_discs", *TWELVE, OPAQUE),
    pov("pov_bubble", (BUBBLE, AMBER, {"transmit": 0.4}), OPAQUE),
    pov("pov_bubble_filter", (BUBBLE, AMBER, {"filter": 0.8}), OPAQUE),
    pov("pov_transparent_no_shadow", (PANE, RED, {"filter": 0.8, "options": "no_shadow", "own": "casts_shadow = false"}),
        (BUBBLE, AMBER, {"transmit": 0.4}), OPAQUE),
    pov("pov_trace_level_1", *PANES, OPAQUE, levels=1),
    pov("pov_trace_level_2", *TWELVE, OPAQUE, levels=2),
    pov("pov_mirror_behind_glass", *PANES, (BEHIND, BALL, {"reflection": 0.6})),
    pov("pov_mirror_level_3", *PANES, (BEHIND, BALL, {"reflection": 0.6}), (BUBBLE, AMBER, {"transmit": 0.4, "reflection": 0.3}),
        levels=3),
    # Each sample of an area light is colored.
    *[pov(f"pov_area_transparent_{n}", *PANES, (BUBBLE, AMBER, {"transmit": 0.4}), OPAQUE, light=area(n, n)) for n in (2, 3, 4, 5)],
    *[pov(f"pov_area_transparent_{n}_adaptive_{level}", *PANES, (BUBBLE, AMBER, {"filter": 0.8}), OPAQUE, light=area(n, n, level))
      for n in (5, 9) for level in (0, 1)],
    pov("pov_area_pale", (PANE, (0.9, 1, 0.95), {"filter": 0.97}), (PANE_2, (1, 1, 1), {"transmit": 0.96}), OPAQUE,
        light=area(9, 9, 0)),
    tachyon("tachyon_opacity", *CLEAR, GLASS_BALL, OPAQUE),
    tachyon("tachyon_trans_vmd", *CLEAR, GLASS_BALL, OPAQUE, mode="Trans_VMD", conventions="transparency = blend"),
    # Highlights are not colored by what the light passes.
    tachyon("tachyon_colored_highlight", *CLEAR, GLASS_BALL, (BEHIND, BALL, {"highlight": 0.5}),
            conventions="transparency = add  attenuate_highlights = false"),
    tachyon("tachyon_occlusion_transparent", *CLEAR, GLASS_BALL, OPAQUE, **OCCLUSION),
    tachyon("tachyon_occlusion_filter_off", *CLEAR, GLASS_BALL, OPAQUE, mode="Shadow_Filter_Off " + OCCLUSION["mode"],
            sky=OCCLUSION["sky"], conventions="transparency = add  transparent_shadow = none"),
    tachyon("tachyon_shadow_filter_off", *CLEAR, GLASS_BALL, OPAQUE, mode="Shadow_Filter_Off",
            conventions="transparency = add  transparent_shadow = none"),
    tachyon("tachyon_trans_max_surfaces", *RINGS, GLASS_BALL, OPAQUE, mode="Trans_VMD Trans_Max_Surfaces 3",
            conventions="transparency = blend  transparent_surfaces = 3"),
    tachyon("tachyon_raydepth", *RINGS, GLASS_BALL, OPAQUE, mode="Trans_VMD", depth=4, conventions="transparency = blend"),
    tachyon("tachyon_raydepth_mirror", *CLEAR, (BUBBLE, AMBER, {"opacity": 0.4, "mirror": 0.3}), (BEHIND, BALL, {"mirror": 0.6}),
            mode="Trans_VMD", depth=3, conventions="transparency = blend"),
]
