# SPDX-License-Identifier: Apache-2.0
"""The rules of lights: one scene each, in the peer's language and in .glint. Both have the same left-handed coordinates: x to the
right, y up, z away from the eye."""
import dataclasses

WIDTH, HEIGHT = 160, 120


@dataclasses.dataclass
class Rule:
    name: str
    program: str  # povray or tachyon
    peer: str     # the scene in its language
    own: str      # the same in .glint; empty: glint reads the peer's file
    width: int = WIDTH
    height: int = HEIGHT
    alpha: bool = False  # both write an alpha channel
    flags: tuple = ()  # of the peer's command
    args: tuple = ()  # further arguments of glint render
    files: dict = dataclasses.field(default_factory=dict)  # bytes of further files, by name
    share: float = 0.99  # of the pixels that must agree


# A floor with two balls, seen from (0, 3, -8) along (0, -0.35, 1).
EYE, FORWARD = (0, 3, -8), (0, -0.35, 1)
BALLS = [((-1.2, 0.8, 0), 0.8, (0.9, 0.5, 0.2)), ((1.1, 0.5, -1), 0.5, (0.3, 0.6, 0.9))]
FLOOR = (0.8, 0.8, 0.7)


def vec(v, left="<", right=">", comma=","):
    return left + f"{comma} ".join(f"{x:.9g}" for x in v) + right


def paren(v):
    return vec(v, "(", ")")


def plain(v):
    return vec(v, "", "", "")


# POV-Ray: no gamma, rounding bytes.

def pov_scene(lights, ball_options=("", ""), highlight=0.4):
    def finish(color):
        return (f"pigment {{ rgb {vec(color)} }} "
                f"finish {{ ambient 0.1 diffuse 0.7 phong {highlight} phong_size 30 }}")
    text = "#version 3.6;\n"
    text += (f"camera {{ location {vec(EYE)} direction {vec(FORWARD)} right <4/3, 0, 0> up <0, 1, 0> }}\n"
             f"plane {{ y, 0 {finish(FLOOR)} }}\n")
    for (center, radius, color), options in zip(BALLS, ball_options):
        text += f"sphere {{ {vec(center)}, {radius} {finish(color)} {options} }}\n"
    return text + lights


def own_scene(lights, ball_options=("", ""), highlight=0.4, head="", shift=(0, 0), ambient=0.1, diffuse=0.7):
    """shift: of the sample in its pixel, in pixels to the right and up."""
    right, up = (4 / 3, 0, 0), (0, 1, 0)
    forward = [f + r * shift[0] / WIDTH + u * shift[1] / HEIGHT for f, r, u in zip(FORWARD, right, up)]
    surface = f"ambient = {ambient}  diffuse = {diffuse}"
    if highlight:
        surface += f"  specular_color = {paren([highlight] * 3)}  shininess = 30"
    text = head + "render { shading = phong }\n"
    text += (f"camera {{ position = {paren(EYE)}  right = {paren(right)}  up = {paren(up)}  forward = {paren(forward)} }}\n"
             f"light {{ type = ambient }}\n"
             f"plane {{ point = (0, 0, 0)  normal = (0, 1, 0)  color = {paren(FLOOR)}  {surface} }}\n")
    for (center, radius, color), options in zip(BALLS, ball_options):
        text += f"sphere {{ center = {paren(center)}  radius = {radius}  color = {paren(color)}  {surface}  {options} }}\n"
    return text + lights


def pov_light(position, color, pov, own, name, **scene):
    """One light. pov, own: its further items in both languages."""
    pov_balls, own_balls = scene.pop("pov_balls", ("", "")), scene.pop("own_balls", ("", ""))
    return Rule(name, "povray",
                pov_scene(f"light_source {{ {vec(position)} color rgb {vec(color)} {pov} }}\n", pov_balls, **scene),
                own_scene(f"light {{ position = {paren(position)}  color = {paren(color)}  {own} }}\n", own_balls, **scene))


def pov_spot(name, radius, falloff, tightness):
    target = (0.3, 0, 0)
    return pov_light((-2, 5, -3), (1, 0.9, 0.8),
                     f"spotlight point_at {vec(target)} radius {radius} falloff {falloff} tightness {tightness}",
                     f"type = spot  target = {paren(target)}  inner_angle = {radius}  outer_angle = {falloff}  "
                     f"tightness = {tightness}", name)


# Tachyon: no highlight, because Tachyon's does not
# depend on attenuation and spot.

TACHYON_AMBIENT, TACHYON_DIFFUSE = 0.1, 0.8


def tachyon_camera():
    length = sum(f * f for f in FORWARD) ** 0.5
    # Tachyon's axes are at right angles: the same view by a zoom and a height of the picture of 1 in all.
    return (f"Begin_Scene\nResolution {WIDTH} {HEIGHT}\n"
            f"Camera Zoom 1 Aspectratio 1 Antialiasing 0 Raydepth 4\n"
            f"  Center {plain(EYE)} Viewdir {plain([f / length for f in FORWARD])} Updir 0 1 0\nEnd_Camera\n"
            f"Background 0 0 0\n")


def tachyon_scene(light):
    def texture(color):
        return (f"Texture Ambient {TACHYON_AMBIENT} Diffuse {TACHYON_DIFFUSE} Specular 0 Opacity 1 "
                f"Phong Plastic 0 Phong_size 30 Color {plain(color)} TexFunc 0")
    text = tachyon_camera() + f"Plane Center 0 0 0 Normal 0 1 0 {texture(FLOOR)}\n"
    for center, radius, color in BALLS:
        text += f"Sphere Center {plain(center)} Rad {radius} {texture(color)}\n"
    return text + light + "End_Scene\n"


def tachyon_frame():
    """Tachyon's camera in .glint: its axes are at right angles."""
    length = sum(f * f for f in FORWARD) ** 0.5
    forward = [f / length for f in FORWARD]
    up = (0, forward[2], -forward[1])
    right = (4 / 3, 0, 0)
    return f"camera {{ position = {paren(EYE)}  right = {paren(right)}  up = {paren(up)}  forward = {paren(forward)} }}\n"


def own_for_tachyon(light, conventions):
    surface = f"ambient = {TACHYON_AMBIENT}  diffuse = {TACHYON_DIFFUSE}"
    text = (f"conventions {{ pixel_sample = top_right  rounding = down  {conventions} }}\nrender {{ shading = diffuse }}\n{tachyon_frame()}"
            f"light {{ type = ambient }}\n"
            f"plane {{ point = (0, 0, 0)  normal = (0, 1, 0)  color = {paren(FLOOR)}  {surface} }}\n")
    for center, radius, color in BALLS:
        text += f"sphere {{ center = {paren(center)}  radius = {radius}  color = {paren(color)}  {surface} }}\n"
    return text + light


def tachyon_light(name, keyword, position, color, peer, own, attenuation=None, conventions="spot_falloff = linear"):
    """attenuation: c0, c1, c2."""
    if attenuation:
        c0, c1, c2 = attenuation
        peer += f" Attenuation Constant {c0} Linear {c1} Quadratic {c2}"
        own += f"  attenuation = {paren(attenuation)}"
        conventions += "  clamp_attenuation = false"
    return Rule(name, "tachyon",
                tachyon_scene(f"{keyword} Center {plain(position)} Rad 0.01 {peer} Color {plain(color)}\n"),
                own_for_tachyon(f"light {{ position = {paren(position)}  color = {paren(color)}  {own} }}\n", conventions))


def tachyon_spot(name, start, end, attenuation=None):
    direction = (2.3, -5, 3)
    return tachyon_light(name, "SpotLight", (-2, 5, -3), (1, 0.9, 0.8),
                         f"Direction {plain(direction)} Falloff_Start {start} Falloff_End {end}",
                         f"type = spot  axis = {paren(direction)}  inner_angle = {start}  outer_angle = {end}", attenuation)


def pov_area(name, columns, rows, sides=((2.4, 0, 0), (0, 0, 2.4)), adaptive=None, color=(1, 0.9, 0.8), form=(), position=(-2, 5, -3)):
    """An area light without jitter. adaptive: POV-Ray's level; None: every sample is traced. form: of circular and orient."""
    pov = f"area_light {vec(sides[0])}, {vec(sides[1])}, {columns}, {rows}"
    own = (f"type = parallelogram  side_u = {paren(sides[0])}  side_v = {paren(sides[1])}  "
           f"samples_u = {columns}  samples_v = {rows}")
    if adaptive is not None:
        pov += f" adaptive {adaptive}"
        own += f"  adaptive = {adaptive}"
    for word in form:
        pov += f" {word}"
        own += "  circular = true" if word == "circular" else "  oriented = true"
    rule = pov_light(position, color, pov, own, name)
    return dataclasses.replace(rule, own="conventions { area_shading = center }\n" + rule.own)


RULES = [
    pov_spot("pov_spot", 12, 22, 0),
    pov_spot("pov_spot_default", 30, 45, 0),
    pov_spot("pov_spot_tight", 15, 35, 20),
    pov_spot("pov_spot_sharp", 18, 18.001, 0),
    pov_light((-2, 5, -3), (1, 0.9, 0.8), "fade_distance 4 fade_power 2", "fade_distance = 4  fade_power = 2", "pov_fade"),
    pov_light((-1, 3, -3), (1, 0.9, 0.8), "fade_distance 1.5 fade_power 0.7", "fade_distance = 1.5  fade_power = 0.7",
              "pov_fade_power"),
    pov_light((-1, 3, -3), (1, 0.9, 0.8), "fade_distance 1.5", "fade_distance = 1.5", "pov_fade_distance_alone"),
    pov_light((-2, 5, -3), (1, 0.9, 0.8), "shadowless", "casts_shadows = false  specular_color = (0, 0, 0)",
              "pov_shadowless"),
    pov_light((-2, 5, -3), (1, 0.9, 0.8), "", "", "pov_no_shadow", pov_balls=("no_shadow", ""),
              own_balls=("casts_shadow = false", "")),
    *[pov_area(f"pov_area_{n}", n, n) for n in (1, 2, 3, 4, 5)],
    *[pov_area(f"pov_area_{n}_adaptive_{level}", n, n, adaptive=level) for n in (4, 5, 9) for level in (0, 1)],
    pov_area("pov_area_not_square", 5, 2, ((3, 0, 1), (0, 1.2, 0))),
    pov_area("pov_area_row", 6, 1, ((3, 0, 0), (0, 0, 1))),
    pov_area("pov_area_dim", 5, 5, adaptive=0, color=(0.09, 0, 0)),
    pov_area("pov_area_less_dim", 5, 5, adaptive=0, color=(0.05, 0.04, 0.02)),
    *[pov_area(f"pov_area_circular_{n}", n, n, form=["circular"]) for n in (2, 3, 4, 5)],
    pov_area("pov_area_circular_not_square", 5, 2, ((3, 0, 1), (0, 1.2, 0)), form=["circular"]),
    *[pov_area(f"pov_area_circular_{n}_adaptive_{level}", n, n, adaptive=level, form=["circular"]) for n in (5, 9) for level in (0, 1)],
    *[pov_area(f"pov_area_orient_{n}", n, n, form=["circular", "orient"]) for n in (2, 3, 5)],
    pov_area("pov_area_orient_not_square", 5, 2, ((3, 0, 1), (0, 1.2, 0)), form=["circular", "orient"]),
    pov_area("pov_area_orient_above", 4, 4, form=["circular", "orient"], position=(0.3, 4, 0)),
    pov_area("pov_area_orient_adaptive", 9, 9, adaptive=1, form=["circular", "orient"]),
    tachyon_spot("tachyon_spot", 12, 22),
    tachyon_spot("tachyon_spot_wide", 0, 40),
    tachyon_light("tachyon_attenuation", "Light", (-1, 2.5, -3), (0.9, 0.8, 1), "", "", (0.1, 0.05, 0.06)),
    tachyon_spot("tachyon_spot_attenuation", 15, 30, (0.2, 0, 0.02)),
]
