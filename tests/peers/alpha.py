# SPDX-License-Identifier: Apache-2.0
"""The rules of alpha: scenes as in lights.py before a background, rendered with an alpha channel."""
from lights import pov_light

BACKGROUND = "0.2, 0.3, 0.4"


def pov_alpha(name, pov_balls=("", ""), own_balls=("", ""), pov="", own="", head=""):
    rule = pov_light((-2, 5, -3), (1, 0.9, 0.8), "", "", name, pov_balls=pov_balls, own_balls=own_balls)
    rule.peer += f"background {{ rgb <{BACKGROUND}> }}\n{pov}"
    rule.own = head + rule.own + f"background = ({BACKGROUND})\n{own}"
    rule.alpha = True
    return rule


def pov_background(name, background, pov_balls=("", ""), version="3.7"):
    """glint reads the peer's file. From version 3.7 on, a background that is not transparent stays."""
    rule = pov_light((-2, 5, -3), (1, 0.9, 0.8), "", "", name, pov_balls=pov_balls)
    rule.peer = rule.peer.replace("#version 3.6;", f"#version {version};\nglobal_settings {{ assumed_gamma 1 }}", 1)
    rule.peer += background
    rule.own = ""
    rule.alpha = True
    return rule


SKY = "sky_sphere { pigment { gradient y color_map { [0 rgb <0.2, 0.3, 0.4>] [1 rgb <0.6, 0.3, 0.1>] } } }\n"
CLEAR = ("", "pigment { rgbt <1, 1, 1, 0.7> }")  # one ball
MIRROR = ("finish { reflection 0.5 }", CLEAR[1])

RULES = [
    pov_background("pov_alpha_opaque", f"background {{ rgb <{BACKGROUND}> }}", MIRROR),
    pov_background("pov_alpha_transmit", f"background {{ rgbt <{BACKGROUND}, 0.25> }}", CLEAR),
    pov_background("pov_alpha_clear", f"background {{ rgbt <{BACKGROUND}, 1> }}", CLEAR),
    pov_background("pov_alpha_none", "", MIRROR),
    pov_background("pov_alpha_sky", SKY, MIRROR),
    pov_background("pov_alpha_old", f"background {{ rgbt <{BACKGROUND}, 0.25> }}", MIRROR, "3.6"),
    pov_background("pov_alpha_old_sky", SKY, MIRROR, "3.6"),
    pov_alpha("pov_alpha"),
    # A mirrored background is opaque in both.
    pov_alpha("pov_alpha_in_mirrors", ("finish { reflection 0.5 }", ""), ("mirror = 0.5", ""),
              head="conventions { mirror = add }\n"),
]
