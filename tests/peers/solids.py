# SPDX-License-Identifier: Apache-2.0
"""Solids: of all kinds of operands, nested, transformed, in shadow, mirrored, transparent, of glass, in fog, clipped."""
from pov import CAMERA, FLOOR, GLAZE, LIGHT, SHINE, rule

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 12 }\n"
RED = "pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.5 }"
BLUE = "pigment { rgb <0.2, 0.3, 0.9> } finish { phong 0.5 }"
MIRROR = "pigment { rgb 0.2 } finish { reflection 0.7 phong 0.6 }"
CLEAR = "pigment { rgbt <0.9, 0.3, 0.2, 0.6> } finish { phong 0.5 }"
CLEAR_BLUE = "pigment { rgbf <0.3, 0.4, 0.9, 0.7> } finish { phong 0.5 }"
GLASS = "pigment { rgbf 1 } finish { phong 0.8 } interior { ior 1.4 }"
BOX = "box { <-1, 0, -1>, <1, 1.6, 1> "
TURN = "rotate <-15, 35, 0>"


def solids(name, objects, camera=CAMERA, light=LIGHT):
    return rule("solid_" + name, FLOOR + objects, head=HEAD + camera + light)


def cut(what, items="", look=RED):
    return f"difference {{ {BOX} {look} }} {what} {items} }}\n"


RULES = [
    solids("difference", cut(f"sphere {{ <0.3, 1.4, -0.8>, 0.8 {BLUE} }}", TURN)),
    solids("intersection", f"intersection {{ {BOX} {RED} }} sphere {{ <0, 0.8, 0>, 1.2 {BLUE} }} {TURN} }}\n"),
    solids("look_of_the_whole", f"difference {{ {BOX} }} sphere {{ <0.3, 1.4, -0.8>, 0.8 {BLUE} }} {RED} {TURN} }}\n"),
    solids("kinds", f"difference {{ {BOX} {RED} }} cylinder {{ <-2, 0.8, 0>, <2, 0.8, 0>, 0.5 {BLUE} }}\n"
           f"cone {{ <0, -0.1, 0>, 0.7, <0, 1.7, 0>, 0.1 {SHINE} }} torus {{ 0.9, 0.3 {BLUE} translate 1.5*y }} {TURN} }}\n"),
    solids("planes", f"intersection {{ plane {{ y, 1.2 }} plane {{ -x, 1 }} plane {{ x, 1 }} plane {{ -y, 0 }} plane {{ <0, 1, -1>, 1 }}\n"
           f"plane {{ z, 1 }} {RED} {TURN} }}\n"),
    solids("nested", f"difference {{ intersection {{ {BOX} {RED} }} sphere {{ <0, 0.8, 0>, 1.3 {SHINE} }} }}\n"
           f"union {{ cylinder {{ -2*z, 2*z, 0.4 translate 0.8*y }} cylinder {{ -2*x, 2*x, 0.4 translate 0.8*y }} {BLUE} }} {TURN} }}\n"),
    solids("difference_in_difference", cut(f"difference {{ sphere {{ <0, 1.6, -0.6>, 0.9 {BLUE} }} sphere {{ <0, 1.6, -0.6>, 0.5 {SHINE} }} }}", TURN)),
    solids("scaled_parts", f"difference {{ sphere {{ 0, 1 scale <1.4, 0.8, 1> {RED} }} sphere {{ 0, 1 scale <0.5, 1.2, 0.5> rotate 40*z translate -0.6*z {BLUE} }}\n"
           f"matrix <1, 0.2, 0, 0.4, 1, 0, 0, 0.3, 1, 0, 0.7, 0> }}\n"),
    solids("inverse", f"intersection {{ {BOX} {RED} }} sphere {{ <0.3, 1.4, -0.8>, 0.8 inverse {BLUE} }} {TURN} }}\n"),
    solids("inverse_union", f"intersection {{ {BOX} {RED} }} union {{ sphere {{ <0.3, 1.4, -0.8>, 0.6 }} sphere {{ <-0.3, 1.4, -0.8>, 0.6 }} inverse {BLUE} }} {TURN} }}\n"),
    solids("mirrored", f"difference {{ sphere {{ <0, 0.9, 0>, 1.1 {MIRROR} }} sphere {{ <0, 1.1, -0.9>, 0.8 {MIRROR} }} }}\n"),
    solids("shadow", cut(f"cylinder {{ <0, 0.8, -2>, <0, 0.8, 2>, 0.6 {BLUE} }}", "rotate 60*y"),
           light="light_source { <5, 3, -2>, rgb 1 }\nlight_source { <-6, 4, -3>, rgb 0.5 }\n"),
    solids("no_shadow", cut(f"sphere {{ <0.3, 1.4, -0.8>, 0.8 {BLUE} }}", TURN + " no_shadow")),
    # Where light passes, inner surfaces count.
    solids("clear", cut(f"sphere {{ <0.3, 1.2, -0.8>, 0.8 {CLEAR_BLUE} }}", TURN, CLEAR)),
    solids("clear_union", f"intersection {{ union {{ sphere {{ <-0.4, 0.8, 0>, 0.8 {CLEAR} }} sphere {{ <0.4, 0.8, 0>, 0.8 {CLEAR_BLUE} }} }}\n"
           f"box {{ <-2, 0, -0.5>, <2, 1.8, 2> {CLEAR} }} }}\n"),
    solids("clear_merge", f"merge {{ sphere {{ <-0.5, 0.8, 0>, 0.8 }} sphere {{ <0.5, 0.8, 0>, 0.8 }} cylinder {{ <-1.5, 0.3, 0>, <1.5, 0.3, 0>, 0.3 }} {CLEAR} }}\n"),
    solids("merge_in_solid", f"intersection {{ merge {{ sphere {{ <-0.4, 0.8, 0>, 0.8 }} sphere {{ <0.4, 0.8, 0>, 0.8 }} {CLEAR} }}\n"
           f"box {{ <-2, 0, -0.5>, <2, 1.8, 2> {CLEAR_BLUE} }} }}\n"),
    solids("merge_of_solids", f"merge {{ difference {{ {BOX} }} sphere {{ <0, 1.5, 0>, 0.7 }} }} cylinder {{ <-1.6, 0.5, 0>, <1.6, 0.5, 0>, 0.3 }} {CLEAR} {TURN} }}\n"),
    solids("glass", f"difference {{ sphere {{ <0, 0.9, 0>, 1 }} cylinder {{ <0, 0.9, -3>, <0, 0.9, 3>, 0.4 }} {GLASS} rotate 25*y }}\n"
           "cylinder { <-3, 0.4, 2>, <3, 0.9, 2>, 0.3 pigment { rgb <1, 0, 0> } }\n"),
    solids("fog", cut(f"sphere {{ <0.3, 1.4, -0.8>, 0.8 {GLAZE} }}", TURN, CLEAR) + "fog { distance 6 color rgb <0.7, 0.7, 0.8> }\n"),
    solids("inside", f"difference {{ box {{ <-4, -3, -9>, <4, 4, 4> {RED} }} sphere {{ <0, 1, -2>, 4.5 {BLUE} }} }}\n"),
    # clipped_by: the cut is open.
    solids("clip_sphere", f"sphere {{ <0, 0.8, 0>, 1 {RED} clipped_by {{ plane {{ <0.3, 0.5, -1>, 0.4 }} }} }}\n"),
    solids("clip_box", f"box {{ <-1, 0, -1>, <1, 1.5, 1> {RED} clipped_by {{ sphere {{ <0, 0.8, 0>, 1.2 }} }} {TURN} }}\n"),
    solids("clip_group", f"union {{ sphere {{ <-0.5, 0.8, 0>, 0.8 {RED} }} sphere {{ <0.5, 0.8, 0>, 0.8 {BLUE} }} clipped_by {{ plane {{ -z, 0.3 }} }} rotate 20*y }}\n"),
    solids("clip_solid", f"difference {{ {BOX} {RED} }} sphere {{ <0, 0.8, 0>, 0.7 {BLUE} }} clipped_by {{ plane {{ <0.2, 0.1, -1>, 0.3 }} }} rotate 20*y }}\n"),
    solids("clip_operand", f"intersection {{ sphere {{ <0, 0.8, 0>, 1 {RED} clipped_by {{ plane {{ <0.5, 1, 0>, 1 }} }} }} {BOX} {BLUE} }} }}\n"),
    solids("clip_and_turn", f"cylinder {{ <0, 0, 0>, <0, 1.5, 0>, 0.9 {RED} rotate 20*z clipped_by {{ box {{ <-2, 0.4, -2>, <2, 1.1, 0.2> rotate 10*x }} }} rotate 40*y }}\n"),
    solids("clip_inverse", f"sphere {{ <0, 0.8, 0>, 1 {RED} clipped_by {{ sphere {{ <0.2, 1.1, -0.8>, 0.7 inverse }} }} }}\n"),
    solids("clip_twice", f"sphere {{ <0, 0.8, 0>, 1 {RED} clipped_by {{ plane {{ y, 1.3 }} plane {{ -z, 0.5 }} }} }}\n"),
    solids("clip_of_solid", f"sphere {{ <0, 0.8, 0>, 1 {RED} clipped_by {{ difference {{ box {{ <-2, 0, -2>, <2, 2, 2> }} cylinder {{ <0, 0.8, -3>, <0, 0.8, 3>, 0.6 }} }} }} rotate 30*y }}\n"),
    solids("cutaway", f"difference {{ {BOX} {RED} }} sphere {{ <0.3, 1.4, -0.8>, 0.8 }} cutaway_textures {TURN} }}\n"),
    solids("bounded", f"difference {{ {BOX} {RED} }} sphere {{ <0.3, 1.4, -0.8>, 0.8 {BLUE} }} bounded_by {{ box {{ <-1, 0, -1>, <1, 1.6, 1> }} }} {TURN} }}\n"),
    solids("many_holes", "difference { box { <-2, 0, -2>, <2, 0.4, 2> }\n" + "".join(
        f"cylinder {{ <{-1.8 + 0.4 * (i % 10):.1f}, -1, {-1.8 + 0.4 * (i // 10):.1f}>, <{-1.8 + 0.4 * (i % 10):.1f}, 1, {-1.8 + 0.4 * (i // 10):.1f}>, 0.15 }}\n"
        for i in range(100)) + f"{RED} rotate <-30, 20, 0> translate 0.8*y }}\n"),
]
