# SPDX-License-Identifier: Apache-2.0
"""How far a long call has come: a bar in a terminal or in a notebook, or a function of the caller's."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Any, Callable, Optional, Type, Union

from ._expect import shown

Progress = Union[None, bool, Callable[[float], object]]
"""None or False: nothing is shown. True: a bar. A function: it is called with the fraction done, 0 to 1."""


def _is_notebook() -> bool:
    """Whether this runs in a Jupyter kernel. IPython is not imported for that."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and "IPKernelApp" in getattr(shell, "config", {})


class _Bar:
    """A line that is overwritten; nothing for work of less than half a second."""

    def __init__(self) -> None:
        self._start = time.monotonic()
        self._shown = False
        self._display: Any = None
        self._in_notebook = _is_notebook()

    def __call__(self, fraction: float) -> None:
        seconds = time.monotonic() - self._start
        if seconds < 0.5 or (fraction >= 1 and not self._shown):
            return
        left = f"{seconds * (1 - fraction) / fraction:.0f} s left" if fraction > 0 else ""
        full = round(24 * fraction)
        text = f"[{'#' * full}{' ' * (24 - full)}] {100 * fraction:3.0f}%  {left}"
        if self._in_notebook:
            from IPython.display import display  # type: ignore[import]

            shown = {"text/plain": text}
            if self._display is None:
                self._display = display(shown, raw=True, display_id=True)
            else:
                self._display.update(shown, raw=True)
        elif sys.stderr.isatty():
            sys.stderr.write("\r" + text + "\x1b[K")
            sys.stderr.flush()
        self._shown = True

    def close(self) -> None:
        if not self._shown:
            return
        if self._in_notebook:
            self._display.update({"text/plain": ""}, raw=True)
        elif sys.stderr.isatty():
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


class reporting:
    """with reporting(progress) as report: the function to call with the fraction done, or None."""

    def __init__(self, progress: Progress) -> None:
        if progress is not None and not callable(progress) and not isinstance(progress, bool):
            raise TypeError(f"progress: expected True, False or a function, found {shown(progress)}")
        self._bar = _Bar() if progress is True else None
        self._report: Optional[Callable[[float], object]] = self._bar
        if callable(progress):
            self._report = progress

    def __enter__(self) -> Optional[Callable[[float], object]]:
        return self._report

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        if self._bar is not None:
            self._bar.close()
