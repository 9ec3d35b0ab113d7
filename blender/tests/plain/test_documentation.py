# SPDX-License-Identifier: Apache-2.0
"""The page of documentation in the zip: all words of docs/blender.md, in proper HTML."""
import html.parser
import pathlib
import re
import unittest

import documentation

SOURCE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "blender.md"
VOID = {"meta", "!doctype"}


class Checked(html.parser.HTMLParser):
    """Collects the text, and what is wrong with the tags."""

    def __init__(self):
        super().__init__()
        self.open, self.text, self.faults, self.links, self.anchors = [], [], [], [], set()

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)
        attrs = dict(attrs)
        self.anchors.add(attrs.get("id"))
        self.links += [attrs["href"]] if "href" in attrs else []

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> at {self.getpos()}")

    def handle_data(self, data):
        self.text.append(data)


class Page(unittest.TestCase):
    def read(self, markdown):
        checked = Checked()
        checked.feed(documentation.page(markdown))
        self.assertEqual((checked.faults, checked.open), ([], []))
        return checked

    def test_it_has_all_words_and_no_marks(self):
        markdown = SOURCE.read_text(encoding="utf-8")
        checked = self.read(markdown)
        text = " ".join(checked.text)
        words = re.findall(r"\w+", re.sub(r"\]\([^)]*\)", "]", re.sub(r"!\[[^]]*\]\([^)]*\)", "", markdown)))
        self.assertGreater(len(words), 3000)
        self.assertEqual(set(words) - set(re.findall(r"\w+", text)), set())
        for mark in ("](", "**", "```", "\n| "):
            self.assertNotIn(mark, text)
        inside = [link[1:] for link in checked.links if link.startswith("#")]
        self.assertGreaterEqual(len(inside), 3)
        self.assertEqual(set(inside) - checked.anchors, set())

    def test_blocks(self):
        checked = self.read("# A & B\n\n- one *two*\n- `a * b`\n\n    x < y\n\n    z\n\n```python\na = 1\n\nb = 2\n```\n\n| h |\n|---|\n| `c` |\n")
        made = documentation.page("# A\n\n```python\na = 1\n\nb = 2\n```\n")
        self.assertIn("<pre>a = 1\n\nb = 2</pre>", made)
        self.assertIn("x < y", "".join(checked.text))
        self.assertIn("a * b", "".join(checked.text))
