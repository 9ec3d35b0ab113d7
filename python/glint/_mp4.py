# SPDX-License-Identifier: Apache-2.0
"""MP4, by the program ffmpeg."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from typing import IO, Optional

import numpy as np
import numpy.typing as npt

from ._errors import GlintError
from ._image import Image

# H.264 that browsers and slides play: even sides (the last line of odd ones is repeated), and HDTV's colors, which are named.
_OPTIONS = (
    "-an -vf scale=out_color_matrix=bt709:out_range=tv -c:v libx264 -crf 18 -pix_fmt yuv420p "
    "-colorspace bt709 -color_primaries bt709 -color_trc bt709 -movflags +faststart -f mp4"
).split()


class Mp4Writer:
    """Passes frames to ffmpeg, which writes a temporary file."""

    def __init__(self, fps: float) -> None:
        program = shutil.which("ffmpeg")
        if program is None:
            raise GlintError("MP4 is written by the program ffmpeg, which is not in PATH; .gif and .png need no program", "io")
        self._program = program
        self._fps = fps
        self._folder = tempfile.TemporaryDirectory(prefix="glint-")
        self._target = os.path.join(self._folder.name, "film.mp4")
        self._said: Optional[IO[bytes]] = None
        self._process: Optional[subprocess.Popen[bytes]] = None

    def _start(self, width: int, height: int) -> subprocess.Popen[bytes]:
        source = f"-f rawvideo -pix_fmt rgb24 -s {width}x{height} -framerate {self._fps!r} -i -".split()
        self._said = tempfile.TemporaryFile()
        self._process = subprocess.Popen(
            [self._program, "-hide_banner", "-loglevel", "error", "-y", *source, *_OPTIONS, self._target],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._said,
        )
        return self._process

    def _fail(self, status: int) -> GlintError:
        assert self._said is not None
        self._said.seek(0)
        lines = self._said.read().decode(errors="replace").strip().splitlines()
        return GlintError(f"ffmpeg ended with status {status}: {lines[-1] if lines else 'it says nothing'}", "io")

    def add(self, image: Image, pixels: npt.NDArray[np.uint8]) -> None:
        width, height = image.size
        process = self._process or self._start(width + width % 2, height + height % 2)
        if width % 2 or height % 2:
            pixels = np.pad(pixels, ((0, height % 2), (0, width % 2), (0, 0)), mode="edge")
        assert process.stdin is not None
        try:
            process.stdin.write(pixels.tobytes())
        except BrokenPipeError:
            raise self._fail(process.wait()) from None

    def finish(self) -> bytes:
        process = self._process
        assert process is not None and process.stdin is not None
        try:
            process.stdin.close()
        except BrokenPipeError:
            pass
        if process.wait() != 0 or not os.path.exists(self._target):
            raise self._fail(process.returncode)
        with open(self._target, "rb") as file:
            return file.read()

    def close(self) -> None:
        """Ends ffmpeg, and removes its file."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            if self._process.stdin is not None and not self._process.stdin.closed:
                try:
                    self._process.stdin.close()
                except BrokenPipeError:
                    pass
        if self._said is not None:
            self._said.close()
        self._folder.cleanup()
