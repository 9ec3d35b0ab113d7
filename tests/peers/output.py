# SPDX-License-Identifier: Apache-2.0
"""How numbers become bytes: POV-Ray's gamma by #version and assumed_gamma, and Tachyon's truncation and sample position."""
import lights

LAMP = ((3, 5, -4), (1, 0.9, 0.8))


def pov_gamma(name, head, conventions):
    """head: what of the POV-Ray scene decides about gamma. The scene has all shades, and none above 1."""
    position, color = LAMP
    peer = lights.pov_scene(f"light_source {{ {lights.vec(position)} color rgb {lights.vec(color)} }}\n", highlight=0)
    own = lights.own_scene(f"light {{ position = {lights.paren(position)}  color = {lights.paren(color)} }}\n", highlight=0,
                           head=f"conventions {{ rounding = half_up  {conventions} }}\n")
    return lights.Rule(name, "povray", peer.replace("#version 3.6;\n", head), own)


def assumed(gamma, version):
    return f"#version {version};\nglobal_settings {{ assumed_gamma {gamma} }}\n"


def tachyon_bytes(name):
    position, color = LAMP
    return lights.tachyon_light(name, "Light", position, color, "", "", conventions="")


RULES = [
    pov_gamma("pov_bytes", "#version 3.6;\n", ""),
    pov_gamma("pov_gamma_3_7", "#version 3.7;\n", "transfer = srgb"),
    pov_gamma("pov_gamma_1", assumed("1", "3.6"), "transfer = srgb"),
    pov_gamma("pov_gamma_2", assumed("2", "3.7"), "transfer = srgb  gamma = 2"),
    pov_gamma("pov_gamma_2_2", assumed("2.2", "3.6"), "transfer = srgb  gamma = 2.2"),
    pov_gamma("pov_gamma_srgb", assumed("srgb", "3.7"), ""),
    tachyon_bytes("tachyon_bytes"),
]
