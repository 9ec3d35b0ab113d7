# SPDX-License-Identifier: Apache-2.0
"""What the page of a live view asks for, and what ends that."""

from __future__ import annotations

import atexit
import contextlib
import json
import math
import os
import threading
import weakref
from typing import Any, Dict, Iterator, List, Optional, Tuple

import numpy as np

from ._errors import GlintError
from ._expect import shown
from ._framing import frame_unset
from ._live_server import Answer, said
from ._sliders import Slider
from ._turns import Turns

_SECONDS_OF_WAITING = 15
_MOST_PAGES = 32


class _Dropped(Exception):
    """A picture that nobody waits for any more."""


class _GivesWay(Exception):
    """The user's program wants to render."""


def _number(request: Dict[str, Any], key: str, lowest: float, highest: float) -> float:
    value = request.get(key, 0)
    if not isinstance(value, (int, float)) or isinstance(value, bool) or not lowest <= value <= highest:
        raise ValueError(f"{key}: expected a number from {lowest:g} to {highest:g}, found {shown(value)}")
    return float(value)


class LiveEngine:
    """Answers the page. It renders under the scene's lock, one picture at a time."""

    def __init__(self, scene: Any, size: Optional[Tuple[int, int]], sliders: List[Slider]) -> None:
        self.scene = scene
        self.size = size
        self.sliders = sliders
        self.version = 0
        self.is_closed = False
        self._changed = threading.Condition()
        self._busy = 0
        self._newest: Dict[int, int] = {}
        _engines.add(self)

    @contextlib.contextmanager
    def _work(self) -> Iterator[None]:
        """Holds the scene; a closed view does no more work."""
        with self._changed:
            self._busy += 1
        try:
            with self.scene._rendering.lock:
                if self.is_closed:
                    raise _Dropped
                yield
        finally:
            with self._changed:
                self._busy -= 1
                self._changed.notify_all()

    def wait_for_work(self, seconds: float) -> None:
        """Until nothing is rendered."""
        with self._changed:
            self._changed.wait_for(lambda: self._busy == 0, seconds)

    def _move(self, right: float, up: float, nearer: float) -> None:
        camera = self.scene.camera
        if right or up:
            camera.orbit(right, up)
        if nearer:
            factor = math.exp(-nearer)
            arm = np.asarray(camera.position, float) - np.asarray(camera.look_at, float)
            length = float(np.linalg.norm(arm)) * factor
            if camera.projection == "orthographic":
                if 1e-12 < camera.width * factor < 1e12:
                    camera.width *= factor
            elif 1e-12 < length < 1e12:
                camera.position = np.asarray(camera.look_at, float) + factor * arm

    def _number_of(self, page: int) -> int:
        """Of a page's newest request."""
        with self._changed:
            number = self._newest.pop(page, 0) + 1
            self._newest[page] = number
            while len(self._newest) > _MOST_PAGES:
                del self._newest[next(iter(self._newest))]
            return number

    def picture(self, request: Dict[str, Any]) -> Answer:
        """Moves the camera and the sliders, and renders: rows of red, green and blue bytes. 204 if the page has since
        asked for another picture; 503 if the user's program renders now."""
        page = int(_number(request, "page", 0, 2**53))
        right, up = _number(request, "right", -1e6, 1e6), _number(request, "up", -1e6, 1e6)
        nearer = _number(request, "nearer", -10, 10)
        values = request.get("values", {})
        if not isinstance(values, dict) or not all(key in map(str, range(len(self.sliders))) for key in values):
            raise ValueError(f"values: expected numbers of sliders and their values, found {shown(values)}")
        wanted = {int(key): _number(values, key, -1e300, 1e300) for key in values}
        number = self._number_of(page)

        def check(fraction: float) -> None:
            if self._newest.get(page, number) != number or self.is_closed:
                raise _Dropped
            if fraction < 1 and self.scene._rendering.is_wanted:
                raise _GivesWay

        try:
            with self._work():
                frame_unset(self.scene, self.size)
                for index, value in wanted.items():
                    self.sliders[index].set(value)
                self._move(right, up, nearer)
                check(0)
                image = self.scene.render(size=self.size, aa=1 if request.get("moving") else None, progress=check)
                content = image.to_uint8().tobytes()
        except _Dropped:
            return Answer(204)
        except _GivesWay:
            return said(503, "Python renders another picture.")
        except (GlintError, ValueError, MemoryError) as error:
            return said(422, error)
        size = ("Glint-Size", f"{image.width}x{image.height}")
        return Answer(200, "application/octet-stream", content, (size,))

    def explain(self, request: Dict[str, Any]) -> Answer:
        """The HTML of the explanation of pixel (x, y)."""
        from ._tools import explain

        x, y = (int(_number(request, key, 0, 1e9)) for key in ("x", "y"))
        try:
            with self._work():
                content = explain(self.scene, x, y, size=self.size)._repr_html_()
        except _Dropped:
            return Answer(204)
        except (GlintError, ValueError, IndexError, MemoryError) as error:
            return said(422, error)
        return Answer(200, "text/html; charset=utf-8", content.encode())

    def changes(self, request: Dict[str, Any]) -> Answer:
        """Waits for another version than the page has, but not for long."""
        version = int(_number(request, "version", -1, 2**53))
        with self._changed:
            self._changed.wait_for(lambda: self.is_closed or self.version != version, _SECONDS_OF_WAITING)
            if self.is_closed:
                return said(410, "The live view is closed.")
            version = self.version
        sliders = [
            dict(label=one.label, value=one.value, lowest=one.lowest, highest=one.highest, step=one.step) for one in self.sliders
        ]
        text = json.dumps({"version": version, "sliders": sliders})
        return Answer(200, "application/json", text.encode())

    def refresh(self) -> None:
        with self._changed:
            self.version += 1
            self._changed.notify_all()

    def close(self) -> None:
        with self._changed:
            self.is_closed = True
            self._changed.notify_all()


_engines: weakref.WeakSet[LiveEngine] = weakref.WeakSet()


@atexit.register
def _end_work() -> None:
    """Before Python ends: a thread that still rendered then would abort the process."""
    engines = list(_engines)
    for engine in engines:
        engine.close()
    for engine in engines:
        engine.wait_for_work(10)


def _forget_work() -> None:
    """In a forked process, which has none of the threads that render."""
    for engine in list(_engines):
        engine.scene._rendering = Turns()
    _engines.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_work)
