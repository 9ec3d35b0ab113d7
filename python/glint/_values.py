# SPDX-License-Identifier: Apache-2.0
"""Points, directions and colors: tuples of three numbers with arithmetic."""

from __future__ import annotations

from typing import Any, Callable, Iterable, NamedTuple, Sequence, TypeVar, Union

import numpy as np
import numpy.typing as npt

VectorLike = Union[Sequence[float], npt.NDArray[Any]]
"""Three numbers: a tuple, a list, a NumPy array."""

ColorLike = Union[Sequence[float], npt.NDArray[Any], float, str]
"""Three numbers (linear RGB), four (the alpha is left out), one for grey, '#rrggbb', or a name; of uint8, 255 is 1."""

_T = TypeVar("_T", bound="_Triple")


class _Triple(tuple):  # type: ignore[type-arg]
    """Arithmetic by component; immutable, so that no change of a copy is lost unnoticed."""

    __slots__ = ()

    def _made(self: _T, numbers: Iterable[float]) -> _T:
        return tuple.__new__(type(self), tuple(numbers))

    def _with(self: _T, other: object, operation: Callable[[float, float], float]) -> _T:
        if isinstance(other, (int, float, np.number)):
            others = (float(other),) * 3
        elif isinstance(other, (tuple, list, np.ndarray)) and len(other) == 3:
            others = tuple(other)  # type: ignore[assignment]
        else:
            return NotImplemented
        return self._made(operation(a, float(b)) for a, b in zip(self, others))

    def __add__(self: _T, other: object) -> _T:
        return self._with(other, lambda a, b: a + b)

    def __radd__(self: _T, other: object) -> _T:
        return self._with(other, lambda a, b: b + a)

    def __sub__(self: _T, other: object) -> _T:
        return self._with(other, lambda a, b: a - b)

    def __rsub__(self: _T, other: object) -> _T:
        return self._with(other, lambda a, b: b - a)

    def __mul__(self: _T, other: object) -> _T:
        return self._with(other, lambda a, b: a * b)

    def __rmul__(self: _T, other: object) -> _T:
        return self._with(other, lambda a, b: b * a)

    def __truediv__(self: _T, other: object) -> _T:
        return self._with(other, lambda a, b: a / b)

    def __neg__(self: _T) -> _T:
        return self._made(-a for a in self)

    def __repr__(self) -> str:
        return "(" + ", ".join(repr(float(a)) for a in self) + ")"


class _Vec3(NamedTuple):
    x: float
    y: float
    z: float


class _Color(NamedTuple):
    r: float
    g: float
    b: float


class _Attenuation(NamedTuple):
    c0: float
    c1: float
    c2: float


class Vec3(_Triple, _Vec3):
    """A point or a direction (x, y, z) in world space, in double precision."""

    __slots__ = ()


class Color(_Triple, _Color):
    """Linear (r, g, b); 1.0 is full intensity. Values are not limited to 1."""

    __slots__ = ()


class Attenuation(_Triple, _Attenuation):
    """The coefficients (c0, c1, c2) of min(1 / (c0 + c1 d + c2 d^2), 1) at distance d."""

    __slots__ = ()
