# SPDX-License-Identifier: Apache-2.0
"""Films."""

from __future__ import annotations

import contextlib
import io
import operator
import os
from typing import IO, Any, Iterable, List, Optional, Union

import numpy as np
import numpy.typing as npt

from ._apng import ApngWriter
from ._expect import expect, plain, shown
from ._files import write_file
from ._image import Image, PathLike, to_image
from ._mp4 import Mp4Writer
from ._progress import Progress, reporting
from ._words import FilmFormat, Transfer

_FORMATS = {".gif": "gif", ".png": "apng", ".apng": "apng", ".mp4": "mp4"}


class _GifWriter:
    """Frames of 256 colors each, by Pillow."""

    def __init__(self, fps: float, plays: int) -> None:
        try:
            import PIL.Image  # type: ignore[import]
        except ImportError:
            raise ImportError("GIF is written by Pillow, which is not installed (pip install pillow); .png does not need it") from None
        if fps > 50:
            raise ValueError(f"fps: a GIF has at most 50, found {fps!r}")
        self._pil = PIL.Image
        self._fps = fps
        self._plays = plays
        self._frames: List[Any] = []

    def add(self, image: Image, pixels: npt.NDArray[np.uint8]) -> None:
        # 1: maximum coverage. Median cut, Pillow's default, turns small things of a color of their own brown or grey.
        self._frames.append(self._pil.fromarray(pixels).quantize(256, method=1, kmeans=1))

    def finish(self) -> bytes:
        # A GIF counts in hundredths of a second: the frames' times are rounded, not their durations.
        times = [round(100 * i / self._fps) for i in range(len(self._frames) + 1)]
        durations = [10 * (end - start) for start, end in zip(times, times[1:])]
        options: Any = {} if self._plays == 1 else {"loop": max(0, self._plays - 1)}
        file = io.BytesIO()
        first, *rest = self._frames
        first.save(file, "GIF", save_all=True, append_images=rest, duration=durations, optimize=False, **options)
        return file.getvalue()


_Writer = Union[_GifWriter, ApngWriter, Mp4Writer]


def _format_of(path: Any, format: Optional[str]) -> str:
    if format is not None:
        if format not in _FORMATS.values():
            raise ValueError(f"format: expected 'gif', 'apng' or 'mp4', found {format!r}")
        return format
    is_file = hasattr(path, "write")
    name = str(getattr(path, "name", "")) if is_file else os.fspath(path)
    found = _FORMATS.get(os.path.splitext(name)[1].lower())
    if found is None:
        if is_file:
            raise ValueError("format: expected 'gif', 'apng' or 'mp4' for a file object whose name does not tell")
        raise ValueError(f"{name!r}: glint writes films as .gif, .png, .apng and .mp4")
    return found


def _plays_of(loop: Any) -> int:
    if isinstance(loop, bool):
        return 0 if loop else 1
    expect("loop", loop, Union[bool, int])
    if not 1 <= loop <= 65535:
        raise ValueError(f"loop: expected True, False or a number from 1 to 65535, found {loop!r}")
    return int(loop)


def _iterate(frames: Any) -> Any:
    is_one = isinstance(frames, (str, bytes, os.PathLike, Image)) or hasattr(frames, "_state")
    if isinstance(frames, np.ndarray) and (frames.ndim < 3 or (frames.ndim == 3 and frames.shape[2] in (3, 4))):
        is_one = True
    if not is_one:
        try:
            return iter(frames)
        except TypeError:
            pass
    raise TypeError(f"frames: expected several pictures, such as a list of images, found {shown(frames)}")


def _open_writer(format: str, fps: float, plays: int, transfer: Optional[Transfer]) -> _Writer:
    if format == "gif":
        return _GifWriter(fps, plays)
    return ApngWriter(fps, plays, transfer) if format == "apng" else Mp4Writer(fps)


@plain
def animate(
    frames: Iterable[Any],
    path: Union[PathLike, IO[bytes]],
    *,
    fps: float = 25,
    loop: Union[bool, int] = True,
    format: Optional[FilmFormat] = None,
    transfer: Optional[Transfer] = None,
    total: Optional[int] = None,
    progress: Progress = None,
) -> None:
    """Writes a film: .gif, .png or .apng (animated PNG), or .mp4.

    frames: Images, arrays (height, width, 3), PIL images or paths, all of one size; or an iterator that renders them,
    such as scene.turntable(60), of which one is asked for after the other. path: a name, or an object with write().
    fps: frames a second, from 0.01 to 1000; of a GIF, at most 50. loop: True: again and again; False: once; a number:
    so often. A player of MP4 decides that itself. format: 'gif', 'apng' or 'mp4', in place of the name's ending.
    transfer: as of Image.to_uint8(). progress: True for a bar, or a function that is called with the fraction done;
    total: the number of frames, if frames does not tell it.

    GIF needs Pillow (ImportError) and has 256 colors a frame. PNG has all colors, and alpha if the frames have it. MP4 needs
    the program ffmpeg (GlintError); a side of an odd number of pixels becomes one longer. A frame of another size is a
    ValueError. The file is replaced when the film is complete: after an error, the old one is as it was.
    """
    expect("fps", fps, float)
    if not 0.01 <= fps <= 1000:
        raise ValueError(f"fps: expected a number from 0.01 to 1000, found {fps!r}")
    if not hasattr(path, "write"):
        expect("path", path, Union[str, os.PathLike])
    iterator = _iterate(frames)
    count = total if total is not None else operator.length_hint(frames, 0)
    size, number = None, 0
    with contextlib.ExitStack() as stack:
        writer = _open_writer(_format_of(path, format), float(fps), _plays_of(loop), transfer)
        if isinstance(writer, Mp4Writer):
            stack.callback(writer.close)
        report = stack.enter_context(reporting(progress))
        for frame in iterator:
            try:
                image = to_image(frame)
                size = size or image.size
                if image.size != size:
                    raise ValueError(f"expected {size[0]}x{size[1]} pixels as the first, found {image.width}x{image.height}")
                writer.add(image, image.to_uint8(transfer=transfer))
            except (TypeError, ValueError) as error:
                kind = TypeError if isinstance(error, TypeError) else ValueError
                raise kind(f"frames[{number}]: {error}") from None
            number += 1
            if report is not None and number < count:
                report(number / count)
        if not number:
            raise ValueError("frames: expected at least one picture, found none")
        content = writer.finish()
        if report is not None:
            report(1.0)
    write = getattr(path, "write", None)
    if write is not None:
        write(content)
    else:
        write_file(os.fspath(path), content)  # type: ignore[arg-type]
