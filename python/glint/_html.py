# SPDX-License-Identifier: Apache-2.0
"""Parts of the HTML that notebooks show: escaped text, pictures, bars and tables, without scripts, styles or files of their own.

All styles are attributes. Text has the color of the page, and lines and bars have colors that are seen on white and on black.
"""

from __future__ import annotations

import base64
import html
import math
import re
from typing import Iterable, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from ._image import Image

Bytes = npt.NDArray[np.uint8]

_LINE = "rgba(128,128,128,0.45)"
_TRACK = "rgba(128,128,128,0.2)"
_CHANNELS = ("#e0564f", "#3fa652", "#4f86e0")
_CELL = "padding:2px 12px 2px 0;text-align:left;vertical-align:top;border:0;background:none"
# What no text of a page has.
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff]")


def escape(text: object) -> str:
    """Text as HTML shows it, whatever it holds."""
    return html.escape(_CONTROL.sub("\ufffd", str(text)))


def number(value: float) -> str:
    """With four digits."""
    return escape(f"{value:.4g}")


def numbers(values: Iterable[float]) -> str:
    """'(0.2, 0.1769, 0.1456)'."""
    return f"({', '.join(number(value) for value in values)})"


def picture(pixels: Bytes, alt: str) -> str:
    """(height, width, 3) of bytes, in its own size: a PNG within the page."""
    height, width = pixels.shape[:2]
    content = base64.b64encode(Image(pixels).to_bytes()).decode()
    return (
        f'<img src="data:image/png;base64,{content}" width="{width}" height="{height}" alt="{escape(alt)}"'
        f' style="max-width:100%;height:auto;image-rendering:pixelated">'
    )


def figure(pixels: Bytes, caption: str, alt: str = "") -> str:
    """A picture with a line of text below, beside others."""
    return (
        f'<div style="display:inline-block;vertical-align:top;margin:0 12px 6px 0">{picture(pixels, alt or caption)}'
        f'<div style="font-size:90%">{escape(caption)}</div></div>'
    )


def swatch(color: Sequence[float]) -> str:
    """A square of a linear color, shown by its bytes without gamma, as pictures are."""
    r, g, b = (round(255 * min(max(float(c), 0.0), 1.0)) if not math.isnan(c) else 0 for c in color)
    return (
        f'<span style="display:inline-block;width:0.9em;height:0.9em;vertical-align:-0.1em;border:1px solid {_LINE};'
        f'background:rgb({r},{g},{b})"></span>'
    )


def _bar(value: float, most: float, color: str, height: int) -> str:
    part = 100 * min(max(value / most, 0.0), 1.0) if most > 0 and math.isfinite(value) else 0.0
    return (
        f'<div style="width:160px;height:{height}px;background:{_TRACK};margin:1px 0">'
        f'<div style="width:{part:.2f}%;height:{height}px;background:{color}"></div></div>'
    )


def color_bars(color: Sequence[float], most: float) -> str:
    """Three bars, for red, green and blue, that are full at `most`."""
    return "".join(_bar(float(value), most, channel, 4) for value, channel in zip(color, _CHANNELS))


def bar(value: float, most: float) -> str:
    """One bar, that is full at `most`."""
    return _bar(value, most, _CHANNELS[2], 12)


def largest(colors: Iterable[Sequence[float]]) -> float:
    """The end of bars for these colors: their greatest number, or 1."""
    finite = [float(value) for color in colors for value in color if math.isfinite(value)]
    return max(finite, default=0.0) or 1.0


def table(rows: Iterable[Sequence[str]], heads: Sequence[str] = ()) -> str:
    """Of rows of HTML, below heads of text."""
    head = "".join(f'<th style="{_CELL};font-weight:bold">{escape(text)}</th>' for text in heads)
    lines = "".join(
        '<tr style="background:none">' + "".join(f'<td style="{_CELL}">{cell}</td>' for cell in row) + "</tr>" for row in rows
    )
    head = f'<thead><tr style="background:none">{head}</tr></thead>' if heads else ""
    return f'<table style="border-collapse:collapse;border:0;margin:4px 0;color:inherit">{head}<tbody>{lines}</tbody></table>'


def heading(content: str) -> str:
    """A bold line of HTML."""
    return f'<div style="font-weight:bold;margin:6px 0 2px 0">{content}</div>'


def details(summary: str, text: str) -> str:
    """Text that a click unfolds."""
    return (
        f'<details style="margin:4px 0"><summary>{escape(summary)}</summary>'
        f'<pre style="margin:4px 0;overflow-x:auto;color:inherit;background:none">{escape(text)}</pre></details>'
    )


def page(*parts: str) -> str:
    """One output of a cell."""
    return f'<div style="color:inherit;line-height:1.4">{"".join(parts)}</div>'


def shrunk(image: Image, most: int = 240) -> Bytes:
    """The bytes of an image, of which each side has at most `most` pixels: every n-th pixel."""
    step = max(1, math.ceil(max(image.size) / most))
    return np.ascontiguousarray(image.to_uint8()[::step, ::step])


def enlarged(pixels: Bytes, factor: int) -> Bytes:
    """Each pixel as a square of factor x factor."""
    return np.repeat(np.repeat(pixels, factor, axis=0), factor, axis=1)


def mark(pixels: Bytes, box: Tuple[int, int, int, int]) -> None:
    """Draws a white frame and a black one around (left, top, right, bottom); what is outside the picture is left out."""
    height, width = pixels.shape[:2]
    left, top, right, bottom = box
    for grown, shade in ((2, (0, 0, 0)), (1, (255, 255, 255))):
        x0, y0, x1, y1 = left - grown, top - grown, right + grown, bottom + grown
        columns, lines = slice(max(x0, 0), max(x1, 0)), slice(max(y0, 0), max(y1, 0))
        for y in (y0, y1 - 1):
            if 0 <= y < height:
                pixels[y, columns] = shade
        for x in (x0, x1 - 1):
            if 0 <= x < width:
                pixels[lines, x] = shade
