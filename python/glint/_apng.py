# SPDX-License-Identifier: Apache-2.0
"""Animated PNG (https://www.w3.org/TR/png-3/), made of the PNG files of its frames."""

from __future__ import annotations

import fractions
import struct
import zlib
from typing import Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._image import Image
from ._words import Transfer

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def _chunks(png: bytes) -> Dict[bytes, bytes]:
    """By kind; those of the same kind one after the other."""
    found: Dict[bytes, bytes] = {}
    at = len(_SIGNATURE)
    while at < len(png):
        (length,) = struct.unpack_from(">I", png, at)
        kind = png[at + 4:at + 8]
        found[kind] = found.get(kind, b"") + png[at + 8:at + 8 + length]
        at += 12 + length
    return found


def _changed(before: Optional[npt.NDArray[np.uint8]], pixels: npt.NDArray[np.uint8]) -> Tuple[int, int, int, int]:
    """(left, top, width, height) of the pixels that differ; one pixel if none does."""
    if before is None:
        return 0, 0, pixels.shape[1], pixels.shape[0]
    differs = (before != pixels).any(axis=2)
    lines, columns = np.flatnonzero(differs.any(axis=1)), np.flatnonzero(differs.any(axis=0))
    if not lines.size:
        return 0, 0, 1, 1
    left, top = int(columns[0]), int(lines[0])
    return left, top, int(columns[-1]) + 1 - left, int(lines[-1]) + 1 - top


class ApngWriter:
    """Frames of one size, one after the other; of each it keeps the compressed pixels that differ from the last one's."""

    def __init__(self, fps: float, plays: int, transfer: Optional[Transfer]) -> None:
        """plays: how often; 0: without end. transfer: of images with alpha."""
        rate = fractions.Fraction(fps).limit_denominator(max(1, int(65535 / max(fps, 1))))
        self._delay = struct.pack(">HH", rate.denominator, rate.numerator)
        self._plays = plays
        self._transfer: Optional[Transfer] = transfer
        self._header = b""
        self._parts: List[bytes] = []
        self._count = 0
        self._sequence = 0
        self._before: Optional[npt.NDArray[np.uint8]] = None

    def _number(self) -> bytes:
        self._sequence += 1
        return struct.pack(">I", self._sequence - 1)

    def add(self, image: Image, pixels: npt.NDArray[np.uint8]) -> None:
        """pixels: the image's bytes (height, width, 3); of an image with alpha, which is written as a whole, unused."""
        if "alpha" in image.layers:
            left, top, width, height = 0, 0, *image.size
            chunks = _chunks(image.to_bytes(transfer=self._transfer))
            self._before = None
        else:
            left, top, width, height = _changed(self._before, pixels)
            chunks = _chunks(Image(pixels[top:top + height, left:left + width]).to_bytes())
            self._before = pixels
        if not self._header:
            self._header = chunks[b"IHDR"]
        elif chunks[b"IHDR"][8:] != self._header[8:]:
            raise ValueError("expected all frames with alpha, or none")
        place = struct.pack(">IIII", width, height, left, top) + self._delay + b"\x00\x00"
        self._parts.append(_chunk(b"fcTL", self._number() + place))
        # glint compresses for speed; level 6 makes films smaller by a third.
        content = zlib.compress(zlib.decompress(chunks[b"IDAT"]), 6)
        self._parts.append(_chunk(b"fdAT", self._number() + content) if self._count else _chunk(b"IDAT", content))
        self._count += 1

    def finish(self) -> bytes:
        control = _chunk(b"acTL", struct.pack(">II", self._count, self._plays))
        return _SIGNATURE + _chunk(b"IHDR", self._header) + control + b"".join(self._parts) + _chunk(b"IEND", b"")
