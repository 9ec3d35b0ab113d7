# SPDX-License-Identifier: Apache-2.0
"""text: characters of fonts. The odd cases are in a small font of tiny_font.py, the others in POV-Ray's own fonts."""
import dataclasses

from pov import CAMERA, FLOOR, LIGHT, SHINE, rule
from sweeps import HEAD
from tiny_font import CHARS, GLYPHS, KERNS, font, tiny_font

CLEAR = "pigment { rgbt <0.9, 0.3, 0.2, 0.6> } finish { phong 0.5 }"
TURN = "rotate <-15, 25, 0> translate <-1.4, 0.6, 0>"
FONTS = {"tiny.ttf": tiny_font(), "mac.ttf": tiny_font(maps=((1, 0),)), "thousand.ttf": tiny_font(units=2048),
         "symbols.ttf": font(GLYPHS, {0xF000 + c if c < 256 else c: g for c, g in CHARS.items()}, kerns=KERNS, maps=((3, 0),))}


def texts(name, objects, camera=CAMERA, head=HEAD):
    of = rule("text_" + name, FLOOR + objects, head=head + camera + LIGHT)
    return dataclasses.replace(of, files={f: data for f, data in FONTS.items() if f'"{f}"' in objects})


def text(characters, file="timrom.ttf", numbers="0.4, 0", items=SHINE + " " + TURN):
    return f'text {{ ttf "{file}" {characters} {numbers} {items} }}\n'


def boxed(characters, file="timrom.ttf", numbers="0.4, 0", items=""):
    """A text over a ball at each corner of its box, and a ball at its middle."""
    return (f"#declare T = {text(characters, file, numbers, items)}#declare A = min_extent(T); #declare B = max_extent(T);\n"
            f"union {{ object {{ T }} sphere {{ A, 0.1 }} sphere {{ B, 0.1 }} sphere {{ (A + B)/2, 0.15 }} translate -(A + B)/2 {SHINE} "
            "rotate 20*y translate 0.8*y }\n")


RULES = [
    texts("one_glyph", text('"R"', items=SHINE + " scale 2.5 " + TURN)),
    texts("serifs", text('"Figg"')),
    texts("without_serifs", text('"Sag@"', "cyrvetic.ttf")),
    texts("crystal", text('"Box&"', "crystal.ttf", items=SHINE + " scale 0.8 " + TURN)),
    texts("logo", text('"P"', "povlogo.ttf", items=SHINE + " scale 2 " + TURN)),
    texts("spaces", text('" i  x "', items=SHINE + " " + TURN)),
    texts("kerning", text('"AVATo"', items=SHINE + " scale 0.9 " + TURN)),
    texts("offset", text('"AVb"', numbers="0.4, <0.3, 0.25, 0.7>")),
    texts("offset_number", text('"AVb"', numbers="0.4, -0.1")),
    texts("offset_back", text('"abc"', numbers="0.4, -0.4*x")),
    texts("thickness_back", text('"Qu"', numbers="-0.7, 0")),
    texts("thickness_none", text('"Qu"', numbers="0, 0")),
    texts("side", text('"dog"', items=SHINE + " rotate 70*y translate <-0.5, 0.6, 0.5>")),
    texts("top", text('"Sc"', items=SHINE + " rotate -60*x scale 1.6 translate <-0.9, 0.6, 0>")),
    texts("scaled", text('"Hej"', items=SHINE + " scale <0.7, 1.5, 3> rotate 30*z translate <-0.6, 0.2, 0>")),
    texts("mirrored", text('"Re"', items=SHINE + " scale <-1, 1, 1> translate <0.8, 0.5, 0>")),
    texts("clear", text('"ego"', items=CLEAR + " " + TURN)),
    texts("no_shadow", text('"Hi"', items=SHINE + " no_shadow scale 1.5 " + TURN)),
    texts("copies", "#declare T = " + text('"ab"', items=SHINE) + "object { T translate -x }\nobject { T rotate 40*y "
          "pigment { rgb x } translate <0.3, 1, 0> }\ntext { T scale 0.7 translate <0.2, -0.2, 0> }\n"),
    texts("union", "union { " + text('"to"', items="pigment { rgb y }") + text('"fly"', items="translate y") + SHINE
          + " scale 0.9 translate <-0.8, 0.1, 0> }\n"),
    texts("computed", text('concat("n", str(7, 0, 0), chr(65))')),
    texts("commas", text('"Co",', numbers="0.4 0")),
    texts("short_name", text('"Co"', "timrom")),
    texts("empty", text('""') + text('"o"')),
    texts("version_31", text('"Old"'), head="#version 3.1;\n"),
    texts("box", boxed('"Hpg"')),
    texts("box_kerning", boxed('"AVi"', numbers="0.4, 0.1*x")),
    texts("box_spaces", boxed('" a "')),
    texts("box_turned", boxed('"Ln"', items="rotate 30*z rotate <20, 40, 0>")),
    texts("box_composed", boxed('"gb"', "tiny.ttf")),
    texts("box_left_side", boxed('"kf"', "tiny.ttf")),
    texts("normals", "#declare T = " + text('"o"', items="scale 2") + "".join(
        f"#declare N = <0, 0, 0>; #declare P = trace(T, <0.55, 0.5, 0.2>, <cos({i}), sin({i}), 0>, N); sphere {{ P*2 - y, 0.15 pigment {{ rgb N*0.5 + 0.5 }} }}\n"
        f"#declare P = trace(T, <0.55, 0.5, 0.2> + 5*<cos({i}), sin({i}), 0.1>, -<cos({i}), sin({i}), 0.1>, N); sphere {{ P*2 - y - x, 0.1 pigment {{ rgb N*0.5 + 0.5 }} }}\n"
        for i in range(6))),
    *(texts("glyph_" + c, text(f'"a{c}"', "tiny.ttf")) for c in "bcdefghiklX"),
    texts("tiny_kerning", text('"abaa"', "tiny.ttf", items=SHINE + " scale 0.8 " + TURN)),
    texts("characters_mac", text('concat("a", chr(233))', "mac.ttf")),
    texts("characters_symbols", text('"ab"', "symbols.ttf")),
    texts("units", text('"gab"', "thousand.ttf", items=SHINE + " scale 1.7 " + TURN)),
    texts("latin", text('concat("a", chr(233), chr(7))', "tiny.ttf")),
    texts("utf8", text('"aé"', "tiny.ttf"), head=HEAD.replace("{", "{ charset utf8")),
    texts("escape", text('"a\\u03b1"', "tiny.ttf")),
]
