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


RULES = [
    pov_alpha("pov_alpha"),
    # A mirrored background is opaque in both.
    pov_alpha("pov_alpha_in_mirrors", ("finish { reflection 0.5 }", ""), ("mirror = 0.5", ""),
              head="conventions { mirror = add }\n"),
]
