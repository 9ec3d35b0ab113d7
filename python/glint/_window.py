# SPDX-License-Identifier: Apache-2.0
"""Pictures in a notebook's output, or in a program that shows them."""

from __future__ import annotations

import os
import pathlib
import sys
import tempfile
import webbrowser
from typing import Any, Optional

from ._errors import warn_of
from ._progress import _is_notebook


def current_cell() -> Optional[int]:
    """The number of the notebook's cell that runs; None outside notebooks."""
    if not _is_notebook():
        return None
    return int(sys.modules["IPython"].get_ipython().execution_count)


def _has_display() -> bool:
    """Whether a program with a window can be started; without one, browsers of the terminal would take its place."""
    if sys.platform in ("win32", "darwin"):
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"))


def show_picture(image: Any) -> None:
    """In a notebook below the cell, else by the system's program for PNG files, or the browser. Without a display, a
    GlintWarning names the file."""
    if _is_notebook():
        from IPython.display import display  # type: ignore[import]

        display(image)
        return
    with tempfile.NamedTemporaryFile(prefix="glint-", suffix=".png", delete=False) as file:
        image.save(file)
    # The program opens the file when it likes, perhaps after the end of this one: so the file stays.
    try:
        if not _has_display():
            warn_of(f"there is no display to show the picture on; it is in the file {file.name}")
        elif not webbrowser.open(pathlib.Path(file.name).as_uri()):
            warn_of(f"no program could be started to show the picture; it is in the file {file.name}")
    except webbrowser.Error as error:
        warn_of(f"no program could be started to show the picture ({error}); it is in the file {file.name}")
