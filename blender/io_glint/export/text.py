# SPDX-License-Identifier: Apache-2.0
"""The text of .glint files: numbers, strings and blocks (docs/formats/glint.md)."""


def number(x):
    """The shortest text with 7 digits: as much as single precision holds."""
    text = f"{x:.7g}"
    return "0" if text == "-0" else text


def vector(values):
    return "(" + ", ".join(number(v) for v in values) + ")"


def matrix(rows):
    """Three rows of four numbers: of a 3x4 or 4x4 matrix."""
    return "(" + ", ".join(vector(row) for row in rows[:3]) + ")"


_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t"}


def string(text):
    """A string in quotes. Control characters are escaped; lone surrogates become U+FFFD."""
    out = []
    for c in text:
        if c in _ESCAPES:
            out.append(_ESCAPES[c])
        elif ord(c) < 32 or ord(c) == 127:
            out.append(f"\\u{ord(c):04x}")
        elif 0xD800 <= ord(c) <= 0xDFFF:
            out.append("\ufffd")
        else:
            out.append(c)
    return '"' + "".join(out) + '"'


def comment(text):
    """One line of comment, whatever the text contains."""
    return "# " + " ".join(string(text)[1:-1].replace('\\"', '"').split())


def block(word, name, entries, indent=""):
    """`word "name" { key = value ... }` on one line; entries: pairs of key and text."""
    title = f"{word} {string(name)}" if name else word
    inside = "  ".join(f"{key} = {value}" for key, value in entries)
    return f"{indent}{title} {{ {inside} }}"


class UniqueNames:
    """Gives every key a name of its own; the first to ask for a name gets it unchanged."""

    def __init__(self):
        self._by_key, self._taken = {}, set()

    def name(self, key, wanted):
        if key not in self._by_key:
            name, n = wanted, 2
            while name in self._taken:
                name, n = f"{wanted} {n}", n + 1
            self._taken.add(name)
            self._by_key[key] = name
        return self._by_key[key]
