# SPDX-License-Identifier: Apache-2.0
"""Exceptions and warnings."""

from __future__ import annotations

import os
import sys
import warnings
from typing import Any, List, Tuple

from ._glint import Diagnostic


class GlintError(Exception):
    """What glint cannot do, and why.

    `code` is one of 'invalid_argument', 'invalid_scene', 'parse', 'io', 'cancelled' and 'internal';
    `diagnostics` has the messages with their file, line and column, or the item of the scene.
    """

    code: str
    diagnostics: List[Diagnostic]

    def __init__(self, message: str, code: str = "internal", diagnostics: List[Diagnostic] = []) -> None:
        super().__init__(message)
        self.code = code
        self.diagnostics = list(diagnostics)

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (*self.args, self.code, self.diagnostics), self.__dict__


class GlintWarning(UserWarning):
    """A likely mistake in a scene. `diagnostic` says where it is."""

    def __init__(self, message: str, diagnostic: Diagnostic) -> None:
        super().__init__(message)
        self.diagnostic = diagnostic

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (*self.args, self.diagnostic), self.__dict__


def make_error(code: str, message: str, diagnostics: List[Diagnostic]) -> GlintError:
    return GlintError(message, code, diagnostics)


def warn_of(message: str) -> None:
    """Issues a warning that has no place in a file."""
    diagnostic = Diagnostic.__new__(Diagnostic)
    diagnostic.__setstate__((1, "", 0, 0, 0, message, "", 0, 0, 0, 0, False))
    warn(diagnostic)


def warn(diagnostic: Diagnostic) -> None:
    """Issues the warning at the line of the user's code."""
    here = os.path.dirname(__file__)
    level = 1
    frame = sys._getframe()
    while frame is not None and os.path.dirname(frame.f_code.co_filename) == here:
        level += 1
        frame = frame.f_back  # type: ignore[assignment]
    warnings.warn(GlintWarning(str(diagnostic), diagnostic), stacklevel=level)
