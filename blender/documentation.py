# SPDX-License-Identifier: Apache-2.0
"""docs/blender.md as one page of HTML for the add-on's zip, without pictures: as much of Markdown as that file uses."""
import html
import re

HEAD = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title>
<style>body {{ max-width: 50em; margin: 2em auto; padding: 0 1em; font: 16px/1.5 sans-serif }}
pre, code {{ background: #eee; font-size: 14px }} pre {{ padding: 0.5em; overflow: auto }}
table {{ border-collapse: collapse }} td, th {{ border: 1px solid #bbb; padding: 0.2em 0.6em; text-align: left; vertical-align: top }}
</style></head><body>
"""
_PICTURE = re.compile(r"!\[[^\]]*\]\([^)]*\)\s*")


def page(markdown):
    """The text of the page."""
    title = re.match(r"# (.*)", markdown)[1]
    blocks = re.split(r"\n{2,}", _PICTURE.sub("", markdown).strip())
    return HEAD.format(title=html.escape(title)) + "\n".join(_joined(blocks)) + "\n</body></html>\n"


def _joined(blocks):
    """Each block; the lines of code that blank lines separate are one."""
    code, ends = [], None  # ends: what the last line of the code is like, or None outside
    for block in blocks:
        if ends is None and block.startswith("```"):
            code, ends = [], "```"
            block = block.split("\n", 1)[1]
        if ends is not None:
            code.append(block)
            if block.endswith(ends):
                yield f"<pre>{html.escape(chr(10).join(code + [''])[:-4].rstrip())}</pre>"
                ends = None
            else:
                code.append("")
        elif block.strip():
            yield _block(block.strip("\n"))


def _block(block):
    lines = block.split("\n")
    heading = re.match(r"(#+) (.*)", block)
    if heading:
        level, text = len(heading[1]), heading[2]
        anchor = re.sub(r"[^\w -]", "", text.lower()).replace(" ", "-")
        return f'<h{level} id="{anchor}">{_inline(text)}</h{level}>'
    if all(line.startswith("    ") for line in lines):
        return "<pre>" + html.escape("\n".join(line[4:] for line in lines)) + "</pre>"
    if lines[0].startswith("|"):
        rows = [[_inline(cell.strip()) for cell in line.strip("|").split("|")] for line in lines if not re.fullmatch(r"[|-]+", line)]
        tagged = [f"<tr>{''.join(f'<{tag}>{cell}</{tag}>' for cell in row)}</tr>"
                  for row, tag in zip(rows, ["th", *["td"] * len(rows)])]
        return "<table>" + "\n".join(tagged) + "</table>"
    for mark, tag in ((r"- ", "ul"), (r"\d+\. ", "ol")):
        if re.match(mark, block):
            items = re.split(rf"^{mark}", block, flags=re.M)[1:]
            return f"<{tag}>" + "".join(f"<li>{_inline(item.strip())}</li>" for item in items) + f"</{tag}>"
    return f"<p>{_inline(block)}</p>"


def _inline(text):
    """Code, emphasis and links; links to other files, which the zip does not have, are only their text."""
    parts = re.split(r"(`[^`]*`)", html.escape(text, quote=False))
    for i, part in enumerate(parts):
        if i % 2:
            parts[i] = f"<code>{part[1:-1]}</code>"
            continue
        part = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", part)
        parts[i] = re.sub(r"(?<![\w*])\*([^*\n]+(?:\n[^*\n]+)?)\*(?!\w)", r"<i>\1</i>", part)
    text = "".join(parts)
    text = re.sub(r"\[([^\]]*)\]\((#[^)]*|https?://[^)]*)\)", r'<a href="\2">\1</a>', text)
    return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
