# SPDX-License-Identifier: Apache-2.0
"""Who renders a scene that has a live view."""

from __future__ import annotations

import threading
from typing import Any


class Turns:
    """with turns: one thread at a time renders. A thread that has the turn may take it again."""

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self._counting = threading.Lock()
        self._waiting = 0

    @property
    def is_wanted(self) -> bool:
        """Whether a thread waits for its turn. Those that take `lock` itself, live views, do not count: they give way."""
        return self._waiting > 0

    def _count(self, change: int) -> None:
        with self._counting:
            self._waiting += change

    def __enter__(self) -> None:
        if self.lock.acquire(blocking=False):
            return
        self._count(1)
        try:
            self.lock.acquire()
        finally:
            self._count(-1)

    def __exit__(self, *error: Any) -> None:
        self.lock.release()
