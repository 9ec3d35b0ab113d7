# SPDX-License-Identifier: Apache-2.0
"""The log of a ray tracer in Python, for diagnose()."""

from __future__ import annotations

import contextlib
import os
import pathlib
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union

import numpy as np

from ._image import PathLike

Pixel = Tuple[int, int]
Pixels = Union[str, Sequence[Any]]


def _to_pixels(pixels: Pixels) -> List[Pixel]:
    pairs: Sequence[Any] = pixels
    if isinstance(pixels, str):
        pairs = [pair.split(",") for pair in pixels.split(";") if pair.strip()]
    try:
        return [(int(x), int(y)) for x, y in (getattr(pair, "pixel", pair) for pair in pairs)]
    except (TypeError, ValueError):
        raise ValueError(f"pixels: expected pairs as [(320, 350), (12, 40)] or '320,350;12,40', found {pixels!r}")


def _words(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield '"%s"' % value if any(c in " \t,;:=#()[]{}" for c in value) else value
    elif np.ndim(value) > 0:
        for part in value:
            yield from _words(part)
    elif np.asarray(value).dtype.kind in "biu":
        yield str(int(value))
    else:
        single = np.asarray(value).dtype in (np.float16, np.float32)
        yield ("%.9g" if single else "%.17g") % value


class _Ray(contextlib.AbstractContextManager["_Ray"]):
    """Closes its ray at the end of a `with` block."""

    def __init__(self, log: TraceLog) -> None:
        self._log = log

    def __exit__(self, *_: object) -> None:
        self._log.end()


class TraceLog(contextlib.AbstractContextManager["TraceLog"]):
    """What a ray tracer computes for some pixels, for diagnose(). The format is docs/formats/trace_log.md.

    pixels: [(x, y), ...], "x,y;x,y", or what propose_pixels() returns. size: (width, height) of the picture.
    path: a file that gets the log when the `with` block ends; `text` has it at any time.

    A program that goes from pixel to pixel calls pixel(), and then ray(), value() and light() in the order in which
    it computes:

        with glint.TraceLog([(40, 18), (2, 2)], size=(64, 48)) as log:
            for y in range(48):
                for x in range(64):
                    log.pixel(x, y)
                    with log.ray("camera"):
                        log.value("direction", direction)
                        log.value("t", t)

    A program whose arrays hold all pixels does not call pixel(). Then each value is an array of height x width, or of
    height * width rows, with one number or three for each pixel; a number, a name or three numbers are the same for
    all pixels. ray(), value() and where() take a mask of the pixels that they concern.
    """

    def __init__(self, pixels: Pixels, size: Tuple[int, int], *, path: Optional[PathLike] = None) -> None:
        self._width, self._height = int(size[0]), int(size[1])
        self._path = path
        self._about: List[str] = [f"size {self._width} {self._height}"]
        self._lines: Dict[Pixel, List[str]] = {pixel: [] for pixel in _to_pixels(pixels)}
        for x, y in self._lines:
            if not (0 <= x < self._width and 0 <= y < self._height):
                raise ValueError(f"pixel {x},{y} is not in a picture of {self._width}x{self._height}")
        # The pixels that are logged now, each with its row in the arrays; and how many rows these have.
        every = {(x, y): y * self._width + x for x, y in self._lines}
        self._active: List[Tuple[Dict[Pixel, int], int]] = [(every, self._width * self._height)]
        self._in_pixel = False

    def __exit__(self, *_: object) -> None:
        if self._path is not None:
            pathlib.Path(os.fspath(self._path)).write_text(self.text, encoding="utf-8")

    @property
    def text(self) -> str:
        """The log, pixel by pixel."""
        lines = list(self._about)
        for (x, y), values in self._lines.items():
            lines += [f"pixel {x} {y}", *values] if values else []
        return "".join(line + "\n" for line in lines)

    def about(self, key: str, *values: Any) -> None:
        """A line on the whole log: about("rows", "bottom"), about("colors", 255)."""
        self._about.append(" ".join([key, *_words(values)]))

    def pixel(self, x: int, y: int) -> bool:
        """Begins a pixel. True if it is one of those that are logged; the calls that follow do nothing if not."""
        at = int(x), int(y)
        self._in_pixel = True
        self._active[:] = [({at: 0} if at in self._lines else {}, 1)]
        return at in self._lines

    def ray(self, kind: str, *, where: Any = None, rows: Any = None) -> _Ray:
        """Begins a ray, which end() closes, or a `with` block of what this returns.

        kind: "camera"; "mirror" or "glass": from the surface that the open ray has hit. where: a mask of the pixels that have
        this ray. rows: if the arrays have rows only for some pixels, the number y * width + x of each row's pixel.
        """
        active, count = self._masked(where)
        if rows is not None:
            if self._in_pixel:
                raise ValueError("rows: only for arrays of all pixels, without pixel()")
            numbers = np.asarray(rows)
            if numbers.ndim != 1 or numbers.dtype.kind not in "iu":
                raise ValueError("rows: expected one whole number for each row: y * width + x of its pixel")
            found = {(x, y): np.flatnonzero(numbers == y * self._width + x) for x, y in active}
            active = {pixel: int(at[0]) for pixel, at in found.items() if len(at)}
            count = len(numbers)
        self._active.append((active, count))
        self.value("ray", kind)
        return _Ray(self)

    def end(self) -> None:
        """Closes the open ray."""
        if len(self._active) < 2:
            raise ValueError("end() without ray()")
        self.value("end")
        self._active.pop()

    def light(self, light: Union[int, str]) -> None:
        """Begins a light, by its number from 1 or its name: the values that follow are its."""
        self.value("light", light)

    def value(self, key: str, *values: Any, where: Any = None) -> None:
        """A quantity: value("t", t), value("N", normals), value("miss", where=~hit). where: a mask of the pixels that have it."""
        active, count = self._masked(where)
        for pixel, row in active.items():
            words = [word for value in values for word in _words(self._of_pixel(value, pixel, row, count))]
            self._lines[pixel].append(" ".join([key, *words]))

    @contextlib.contextmanager
    def where(self, mask: Any) -> Iterator[None]:
        """Within the `with` block only the pixels of the mask are logged."""
        self._active.append(self._masked(mask))
        try:
            yield
        finally:
            self._active.pop()

    def _masked(self, mask: Any) -> Tuple[Dict[Pixel, int], int]:
        active, count = self._active[-1]
        if mask is not None:
            active = {p: row for p, row in active.items() if np.all(self._of_pixel(mask, p, row, count))}
        return active, count

    def _of_pixel(self, value: Any, pixel: Pixel, row: int, count: int) -> Any:
        """The pixel's part of an array, or the value if it is the same for all pixels."""
        if self._in_pixel or isinstance(value, str):
            return value
        array = np.asarray(value)
        if count == self._width * self._height and array.shape[:2] == (self._height, self._width):
            return array[pixel[1], pixel[0]]
        if array.shape == (3,) and count == 3:
            raise ValueError("three numbers: of three rows (give them the shape (3, 1)), or one vector ((1, 3))?")
        if array.ndim > 0 and array.shape[0] == count:
            return array[row]
        if array.size in (1, 3) and array.ndim < 3:
            return array.reshape(-1) if array.ndim else array
        raise ValueError(
            f"an array of the shape {array.shape}: expected {self._height} x {self._width} or {count} rows"
        )
