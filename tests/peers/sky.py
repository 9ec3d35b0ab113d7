# SPDX-License-Identifier: Apache-2.0
"""The rules of light from all directions (ambient occlusion) and of background gradients: one scene each, as in lights.py."""
import lights
from lights import Rule, paren, plain, vec

COLOR = (0.8, 0.9, 1)
POSITION = (-2, 5, -3)


def occlusion(name, samples, direct=None, sky_light=False, has_light=False):
    """Tachyon's ambient occlusion: one sequence of directions for all pixels."""
    own = f"occlusion {{ method = fixed  samples = {samples}  color = {paren(COLOR)}  direct = {1 if direct is None else direct} }}\n"
    if sky_light:
        peer = f"Sky_Light NumSamples {samples} Color {plain(COLOR)}\n"
    else:
        peer = f"Shader_Mode Full Ambient_Occlusion Ambient_Color {plain(COLOR)} "
        peer += f"Rescale_Direct {1 if direct is None else direct} Samples {samples} End_Shader_Mode\n"
    if has_light:
        peer += f"Light Center {plain(POSITION)} Rad 0.01 Color 0.9 0.8 0.7\n"
        own += f"light {{ position = {paren(POSITION)}  color = (0.9, 0.8, 0.7) }}\n"
    return Rule(name, "tachyon", lights.tachyon_scene(peer), lights.own_for_tachyon(own, ""))


BOTTOM, TOP = (0.9, 0.3, 0.1), (0.1, 0.4, 0.9)


def gradient(name, up, bottom, top, orthographic=False):
    """Tachyon's gradients. A plane gradient depends on the ray's origin, so its camera is orthographic."""
    kind = "Sky_Ortho_Plane" if orthographic else "Sky_Sphere"
    length = sum(u * u for u in up) ** 0.5
    peer = lights.tachyon_scene(f"Background_Gradient {kind} Updir {plain([u / length for u in up])} TopVal {top} "
                                f"BottomVal {bottom} TopColor {plain(TOP)} BottomColor {plain(BOTTOM)}\n")
    own = lights.own_for_tachyon(
        f"background_gradient {{ type = {'plane' if orthographic else 'sphere'}  up = {paren(up)}  bottom = {bottom}  top = {top}  "
        f"bottom_color = {paren(BOTTOM)}  top_color = {paren(TOP)} }}\n", "")
    # Without the floor, so that the gradient is seen below the horizon.
    peer = "\n".join(line for line in peer.split("\n") if not line.startswith("Plane "))
    own = "\n".join(line for line in own.split("\n") if not line.startswith("plane "))
    if orthographic:
        peer = peer.replace("Camera Zoom 1", "Camera Projection Orthographic Zoom 0.25")
        own = orthographic_frame(own)
    return Rule(name, "tachyon", peer, own)


def orthographic_frame(own):
    """The same view, parallel: four times as high and wide as the plane at distance 1."""
    length = sum(f * f for f in lights.FORWARD) ** 0.5
    forward = [f / length for f in lights.FORWARD]
    right, up = (16 / 3, 0, 0), (0, 4 * forward[2], -4 * forward[1])
    camera = (f"camera {{ projection = orthographic  position = {paren(lights.EYE)}  right = {paren(right)}  up = {paren(up)}  "
              f"forward = {paren(forward)} }}")
    return "\n".join(camera if line.startswith("camera ") else line for line in own.split("\n"))


def pov_sky(name, transform, bottom, repeats):
    """POV-Ray's sky_sphere with a gradient of two colors."""
    peer = (f"sky_sphere {{ pigment {{ gradient y color_map {{ [0 rgb {vec(BOTTOM)}] [1 rgb {vec(TOP)}] }} {transform} }} }}\n"
            f"light_source {{ {vec(POSITION)} color rgb <1, 0.9, 0.8> }}\n")
    own = (f"background_gradient {{ bottom = {bottom}  top = 1  bottom_color = {paren(BOTTOM)}  top_color = {paren(TOP)}  "
           f"repeats = {'true' if repeats else 'false'} }}\n"
           f"light {{ position = {paren(POSITION)}  color = (1, 0.9, 0.8) }}\n")
    peer, own = lights.pov_scene(peer), lights.own_scene(own)
    peer = "\n".join(line for line in peer.split("\n") if not line.startswith("plane "))
    own = "\n".join(line for line in own.split("\n") if not line.startswith("plane "))
    return Rule(name, "povray", peer, own)


RULES = [
    occlusion("tachyon_occlusion", 16),
    occlusion("tachyon_occlusion_many", 100),
    occlusion("tachyon_occlusion_direct", 24, direct=0.4, has_light=True),
    occlusion("tachyon_sky_light", 12, sky_light=True, has_light=True),
    gradient("tachyon_gradient_sphere", (0, 1, 0), -0.6, 0.1),
    gradient("tachyon_gradient_tilted", (1, 2, -1), -0.9, 0.2),
    gradient("tachyon_gradient_plane", (0, 1, 0), 1.5, 4, orthographic=True),
    pov_sky("pov_sky_sphere", "scale 2 translate -1", -1, False),
    pov_sky("pov_sky_sphere_repeats", "", 0, True),
]
