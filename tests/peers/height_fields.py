# SPDX-License-Identifier: Apache-2.0
"""height_field of pictures of all kinds that glint reads, with water, smooth, transformed."""
import struct
import zlib

from lights import Rule
from pov import CAMERA, FLOOR, LIGHT, SHINE

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
PLACE = "translate <-0.5, 0, -0.5> scale <3, 1, 3> rotate <-15, 25, 0>"
SIZE = (13, 11)


def height(x, z):
    """From 0 to 1, with a hill, a valley and steps."""
    return 0.8 * (0.5 + 0.3 * ((x * x + 3 * z) % 7) / 7 * (z % 3 == 1) + 0.02 * x - 0.04 * z + 0.25 * (4 < x < 8) - 0.2 * (x > 9))


def rows(pixel):
    return [b"".join(pixel(height(x, z)) for x in range(SIZE[0])) for z in range(SIZE[1])]


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(bits, kind, pixel, palette=b""):
    header = struct.pack(">IIBBBBB", *SIZE, bits, kind, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + palette + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows(pixel)))) +
            chunk(b"IEND", b""))


def netpbm(kind, greatest, pixel):
    return b"%s\n%d %d\n%d\n" % (kind, *SIZE, greatest) + b"".join(rows(pixel))


def tga(kind, bits, pixel):
    return struct.pack("<BBBHHBHHHHBB", 0, 0, kind, 0, 0, 0, 0, 0, *SIZE, bits, 0x20) + b"".join(rows(pixel))


def byte(h):
    return bytes((int(255 * h),))


def word(h):
    return struct.pack(">H", int(65535 * h))


def color(h):
    return struct.pack(">H", int(65535 * h)) + b"\x30"


FILES = {"grey.png": png(8, 0, byte), "grey16.png": png(16, 0, word), "color.png": png(8, 2, color), "alpha.png": png(8, 6, lambda h: color(h) + b"\x80"),
         "grey_alpha.png": png(8, 4, lambda h: byte(h) + b"\x80"), "color16.png": png(16, 2, lambda h: word(h) + word(0.7 * h) + word(0.2)),
         "palette.png": png(8, 3, byte, chunk(b"PLTE", bytes(7 * i % 256 for i in range(768)))), "grey_alpha16.png": png(16, 4, lambda h: word(h) + b"\x80\x80"),
         "grey.pgm": netpbm(b"P5", 255, byte), "grey16.pgm": netpbm(b"P5", 65535, word), "color.ppm": netpbm(b"P6", 255, color),
         "color16.ppm": netpbm(b"P6", 65535, lambda h: word(h) + word(0.7 * h) + word(0.2)),
         "color.tga": tga(2, 24, lambda h: color(h)[::-1]), "grey.tga": tga(3, 8, byte)}


def field(name, items, after="", camera=CAMERA, light=LIGHT, look=SHINE, floor=FLOOR):
    text = f"{HEAD}{camera}{light}{floor}height_field {{ {items} {look} {PLACE} {after} }}\n"
    return Rule("field_" + name, "povray", text, "", files=FILES)


RULES = [field(name.replace(".", "_"), f'{name.split(".")[1]} "{name}"') for name in FILES]
RULES += [
    field("without_type", '"grey16.png"'),
    field("smooth", 'png "grey16.png" smooth'),
    field("smooth_8_bits", 'pgm "grey.pgm" smooth'),
    field("smooth_scaled", 'png "grey16.png" smooth', "scale <1, 0.3, 1>"),
    field("water", 'png "grey16.png" water_level 0.45'),
    field("water_smooth", 'png "grey16.png" water_level 0.55 smooth'),
    field("water_above", 'png "grey16.png" water_level 1.2'),
    field("shadow", 'png "grey16.png"', light="light_source { <5, 2, -2>, rgb 1 }\nlight_source { <-6, 3, 3>, rgb 0.5 }\n"),
    field("below", 'png "grey16.png"', "rotate 180*z translate y"),
    field("near", 'png "grey16.png"', camera="camera { location <0.3, 1.2, -1.7> look_at <0, 0.3, 0> angle 40 }\n"),
    field("mirrored", 'png "grey16.png" smooth', look="pigment { rgb 0.2 } finish { reflection 0.7 phong 0.6 }"),
    field("clear", 'png "grey16.png"', look="pigment { rgbt <0.9, 0.3, 0.2, 0.6> } finish { phong 0.5 }"),
    Rule("field_copies", "povray", f'{HEAD}{CAMERA}{LIGHT}{FLOOR}#declare F = height_field {{ png "grey16.png" smooth {SHINE} }}\n' + "".join(
        f"object {{ F translate -0.5 scale <{s}, 0.6, {s}> rotate {40 * s}*y translate <{1.5 * s - 2.2}, 0.7, {s}> }}\n" for s in (0.7, 1.2, 1.9)),
        "", files=FILES),
]
