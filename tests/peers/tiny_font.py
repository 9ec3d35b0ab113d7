# SPDX-License-Identifier: Apache-2.0
"""Makes a small TrueType font, for tests of POV-Ray's `text`."""
import struct


def simple(contours, box=None):
    """A glyph of contours: lists of (x, y, on the curve)."""
    points = [p for c in contours for p in c]
    if not points:
        return b""
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    ends, n = b"", 0
    for c in contours:
        n += len(c)
        ends += struct.pack(">H", n - 1)
    box = box or (min(xs), min(ys), max(xs), max(ys))
    flags = bytes(p[2] for p in points)
    steps = b"".join(struct.pack(">h", b - a) for v in (xs, ys) for a, b in zip([0] + v, v))
    return struct.pack(">hhhhh", len(contours), *box) + ends + b"\0\0" + flags + steps


def composed(parts, box):
    """A glyph of others: (number, dx, dy, scale)."""
    out = struct.pack(">hhhhh", -1, *box)
    for i, (number, dx, dy, scale) in enumerate(parts):
        more = 0x20 if i + 1 < len(parts) else 0
        out += struct.pack(">HHhhh", 0x0003 | 0x0008 | more, number, dx, dy, int(scale * 16384))
    return out


def font(glyphs, chars, units=1000, kerns=(), maps=((3, 1),), first=0):
    """The bytes of a font. glyphs: (data, advance, left side); chars: glyph number by character; kerns: (left
    glyph, right glyph, units)."""
    data, places = b"", [0]
    for outline, _, _ in glyphs:
        data += outline + b"\0" * (-len(outline) % 4)
        places.append(len(data))
    boxes = [struct.unpack(">hhhh", g[0][2:10]) for g in glyphs if g[0]] or [(0, 0, 0, 0)]
    low = [min(b[i] for b in boxes) for i in range(2)]
    high = [max(b[i] for b in boxes) for i in (2, 3)]
    count = len(glyphs)
    tables = {
        "head": struct.pack(">IIIIHHQQhhhhHHhhh", 0x10000, 0x10000, 0, 0x5F0F3CF5, 0, units, 0, 0, *low, *high,
                            0, 8, 2, 1, 0),
        "hhea": struct.pack(">IhhhHhhhhhhhhhhhH", 0x10000, high[1], low[1], 0, max(g[1] for g in glyphs),
                            0, 0, high[0], 1, 0, 0, 0, 0, 0, 0, 0, count),
        "maxp": struct.pack(">IHHHHHHHHHHHHHH", 0x10000, count, 99, 9, 99, 9, 1, 0, 0, 0, 0, 0, 0, 4, 2),
        "hmtx": b"".join(struct.pack(">Hh", g[1], g[2]) for g in glyphs),
        "loca": b"".join(struct.pack(">I", p) for p in places),
        "glyf": data,
    }
    ends = sorted(chars) + [0xFFFF]
    segments = [(c, chars.get(c, 0)) for c in ends]
    body = struct.pack(">HHHH", 2 * len(ends), 0, 0, 0) + b"".join(struct.pack(">H", c) for c in ends) + b"\0\0"
    body += b"".join(struct.pack(">H", c) for c in ends)
    body += b"".join(struct.pack(">H", (g - c) & 0xFFFF if c != 0xFFFF else 1) for c, g in segments)
    body += b"\0\0" * len(ends)
    table4 = struct.pack(">HHH", 4, len(body) + 6, 0) + body
    table0 = struct.pack(">HHH", 0, 262, 0) + bytes(chars.get(c, 0) for c in range(256))
    entries, subtables = b"", b""
    for platform, encoding in maps:
        entries += struct.pack(">HHI", platform, encoding, 4 + 8 * len(maps) + len(subtables))
        subtables += table0 if platform == 1 else table4
    tables["cmap"] = struct.pack(">HH", 0, len(maps)) + entries + subtables
    if kerns:
        pairs = b"".join(struct.pack(">HHh", *k) for k in sorted(kerns))
        tables["kern"] = struct.pack(">HHHHHHHHH", 0, 1, 0, 14 + len(pairs), 1, len(kerns), 0, 0, 0) + pairs
    tables["name"] = struct.pack(">HHH", 0, 0, 6)
    tables["post"] = struct.pack(">IIhhIIIII", 0x30000, 0, 0, 0, 0, 0, 0, 0, 0)
    offset = 12 + 16 * len(tables)
    head, rest = struct.pack(">IHHHH", 0x10000, len(tables), 0, 0, 0), b""
    for tag in sorted(tables):
        table = tables[tag] + b"\0" * (-len(tables[tag]) % 4)
        check = sum(struct.unpack(f">{len(table) // 4}I", table)) & 0xFFFFFFFF
        head += tag.encode() + struct.pack(">III", check, offset + len(rest), len(tables[tag]))
        rest += table
    return head + rest


def box(x0, y0, x1, y1, hole=False):
    points = [(x0, y0, 1), (x0, y1, 1), (x1, y1, 1), (x1, y0, 1)]
    return points[::-1] if hole else points


def drop(x, y, r, hole=False):
    """A round contour: all points off the curve but one."""
    points = [(x, y + r, 1), (x + r, y + r, 0), (x + r, y - r, 0), (x - r, y - r, 0), (x - r, y + r, 0)]
    return points[::-1] if hole else points


GLYPHS = [
    (simple([box(50, 0, 450, 700), box(100, 50, 400, 650, True)]), 500, 50),        # missing
    (simple([]), 300, 0),                                                           # space
    (simple([box(100, 0, 600, 600), box(200, 100, 500, 500, True)]), 700, 100),     # a: a hole
    (simple([box(100, 0, 500, 500), box(300, 200, 700, 700)]), 800, 100),           # b: overlap, same turn
    (simple([box(100, 0, 500, 500), box(300, 200, 700, 700, True)]), 800, 100),     # c: overlap, other turn
    (simple([box(100, 0, 700, 700, True)]), 800, 100),                              # d: turned the other way
    (simple([drop(400, 300, 300), drop(400, 300, 150, True)]), 800, 100),           # e: round
    (simple([box(100, 0, 600, 600)]), 700, 20),                                     # f: left side is not its box
    (composed([(2, 0, 0, 1), (6, 100, 400, 0.5)], (100, 0, 600, 700)), 700, 100),   # g: composed
    (simple([box(100, 0, 600, 600), box(200, 100, 500, 500)]), 700, 100),           # h: within, same turn
    (simple([[(100, 0, 1), (300, 600, 0), (500, 0, 1)]]), 600, 100),                # i: extremum off the curve
    (simple([[(100, 300, 0), (300, 600, 0), (500, 300, 0), (300, 0, 0)]]), 600, 100),  # j: no point on it
    (simple([box(-200, -100, 300, 600)]), 400, -200),                               # k: left of its origin
    (simple([[(100, 0, 1), (700, 600, 1), (100, 600, 1), (700, 0, 1)]]), 800, 100),  # l: crosses itself
]
CHARS = {32: 1, 233: 6, 0x3B1: 5}
CHARS.update({ord("a") + i: 2 + i for i in range(len(GLYPHS) - 2)})
KERNS = [(2, 3, -100), (3, 2, 50), (2, 1, 70)]


def tiny_font(**options):
    return font(GLYPHS, CHARS, kerns=KERNS, **options)


HEADER = """// SPDX-License-Identifier: Apache-2.0
#pragma once
// The font of tests/peers/tiny_font.py, which prints this file.
#include <string>
#include <string_view>

namespace glint::test {

inline std::string tiny_font() {
    static constexpr std::string_view k_digits =
%s;
    const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
    std::string bytes;
    for (std::size_t i = 0; i < k_digits.size(); i += 2)
        bytes += static_cast<char>(value(k_digits[i]) * 16 + value(k_digits[i + 1]));
    return bytes;
}

}  // namespace glint::test
"""


if __name__ == "__main__":
    digits = tiny_font().hex()
    print(HEADER % "\n".join(f'        "{digits[i:i + 96]}"' for i in range(0, len(digits), 96)), end="")
