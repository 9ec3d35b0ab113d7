# SPDX-License-Identifier: Apache-2.0
"""What a surface's color may be besides the same everywhere: an image, or colors of the mesh; and glint's textures."""
from dataclasses import dataclass, field
from typing import NamedTuple

from .images import Variant
from .text import block, number, string, vector

IDENTITY = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
WRAPS = {"REPEAT": "repeat", "EXTEND": "clamp", "CLIP": "clip", "MIRROR": "mirror"}
WHITE = (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class ImageUse:
    """An Image Texture node. Equal ones show the same."""

    image: object = field(compare=False)
    name: str  # the image's
    uv: str  # the name of the UV map; empty: the one for renders
    extension: str = "REPEAT"
    is_smooth: bool = True
    uv_map: tuple = IDENTITY
    color: bool = True  # whether its color is used; else only its alpha
    alpha: bool = False  # whether its alpha is the surface's

    @property
    def has_border(self):
        """Whether a border of one texel ends the image: Cycles mixes with black between the edge and half a texel beyond, where the
        wrap `clip` mixes with the texel at the edge."""
        return self.extension == "CLIP" and self.is_smooth

    @property
    def variant(self):
        return Variant(self.color, self.alpha, self.has_border)

    def entries(self, shown, encoding, cutoff):
        """Keys of a `texture`. cutoff: the alpha from which on there is a surface; None: alpha blends."""
        rows = self.uv_map
        if self.has_border:  # it is black and transparent
            sizes = tuple(self.image.size)
            rows = tuple(tuple((v * n + (1 if i == 2 else 0)) / (n + 2) for i, v in enumerate(row)) for row, n in zip(rows, sizes))
        yield "file", string(shown)
        yield "encoding", encoding
        wrap = "clamp" if self.has_border else WRAPS[self.extension]
        if wrap != "repeat":
            yield "wrap_u", wrap
            yield "wrap_v", wrap
        if not self.is_smooth:
            yield "filter", "nearest"
        if not self.alpha:
            yield "alpha", "ignore"
        elif cutoff is not None:
            yield "alpha", "mask"
            yield "alpha_cutoff", number(cutoff)
        if rows != IDENTITY:
            yield "uv_map", f"({', '.join(vector(row) for row in rows)})"


class Pattern(NamedTuple):
    """A color that differs from place to place: tint times the image's color times that of the mesh's layer."""

    tint: tuple = WHITE
    image: ImageUse | None = None
    layer: str | None = None  # the name of a color attribute; empty: the one for renders

    @property
    def varies(self):
        return self.image is not None or self.layer is not None


class Look(NamedTuple):
    """What the triangles of a material need of their mesh: the UV map and the color attribute, by name, and what its colors are
    multiplied by."""

    uv: str | None
    layer: str | None
    tint: tuple = WHITE


def product(a, b):
    """Two Patterns multiplied; None if glint cannot."""
    if (a.image and b.image) or (a.layer is not None and b.layer is not None):
        return None
    tint = tuple(x * y for x, y in zip(a.tint, b.tint))
    return Pattern(tint, a.image or b.image, b.layer if a.layer is None else a.layer)


def texture_block(name, use, file, encoding, cutoff):
    return block("texture", name, use.entries(file, encoding, cutoff))
