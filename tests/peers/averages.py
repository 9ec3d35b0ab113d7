# SPDX-License-Identifier: Apache-2.0
"""`average` of pigments in POV-Ray's scenes, which glint reads as they are."""
from layers import FINISH, LINES, RINGS, SQUARES, layer
from lights import Rule
from patterns import BALL, FLOOR, HEAD

CHECKER = "checker rgb <0.9, 0.2, 0.1> rgb <0.2, 0.3, 0.9> scale 0.3"
SLOPES = "".join(f"[1 gradient {axis} color_map {{ [0 rgb 0] [1 rgb <{color}> * 3] }}] "
                 for axis, color in (("x", "0.9, 0.2, 0.1"), ("y", "0.1, 0.7, 0.2"), ("z", "0.2, 0.3, 0.9")))


def average(parts, after=""):
    return f"pigment {{ average pigment_map {{ {parts} }} {after} }}"


def rule(name, objects):
    return Rule("average_" + name, "povray", HEAD + FLOOR + objects, "")


def ball(name, parts, after="", texture=""):
    return rule(name, BALL % f"texture {{ {average(parts, after)} {FINISH} }} {texture}")


RULES = [
    ball("colors", "[1 rgb <0.9, 0.2, 0.1>] [1 rgb <0.1, 0.2, 0.9>] [2 rgb 0.8]"),
    ball("pattern_and_color", f"[1 {RINGS}] [2 rgb <0.1, 0.2, 0.9>]"),
    ball("color_and_pattern", f"[2 rgb <0.1, 0.2, 0.9>] [0.5 {RINGS}]"),
    ball("patterns", f"[1 {RINGS}] [2 {CHECKER}]"),
    ball("three", f"[1 {RINGS}] [0.3 {CHECKER}] [0.7 rgb <0.1, 0.9, 0.3>]"),
    ball("no_weight", f"[0 {RINGS}] [1 {CHECKER}]"),
    ball("slopes", SLOPES, "scale 1.3 rotate <20, 30, 10>"),
    ball("moved", SLOPES, "rotate 20*z", "scale 0.7 translate 0.2*x"),
    ball("within", f"[1 average pigment_map {{ [1 {RINGS}] [1 {CHECKER}] }} scale 1.5] [1 rgb <0.1, 0.9, 0.3>]"),
    rule("under", BALL % (f"texture {{ {average(f'[1 {RINGS}] [2 {CHECKER}]')} {FINISH} }}" + layer(SQUARES))),
    rule("over", BALL % (layer(LINES) + f"texture {{ {average(f'[1 {RINGS}] [2 {CHECKER}]')} {FINISH} }}")),
    rule("named", f"#declare P = {average(f'[1 {RINGS}] [2 {CHECKER}]')}\n" + BALL % f"pigment {{ P scale 0.8 }} {FINISH}"),
    rule("named_part", f"#declare P = pigment {{ {RINGS} }}\n" + BALL % f"{average('[1 P scale 2] [1 P rotate 30*z]')} {FINISH}"),
    rule("triangle", "triangle { <-1, -0.8, 0>, <1, -0.8, 0>, <0, 1, 0> texture { %s %s } }\n" %
         (average(SLOPES, "matrix <1.01, 0, 1, 0, 1.01, 1, 0, 0, 1, -0.002, -0.002, -1> "
                  "matrix <2, 0, 0, 1, 1.8, 0, 0, 0, 1, -1, -0.8, 0>"), FINISH)),
]
