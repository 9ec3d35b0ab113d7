# SPDX-License-Identifier: Apache-2.0
"""Numbers of a scene that a live view changes."""

from __future__ import annotations

import math
import numbers
from typing import Any, List, Mapping, MutableMapping, Optional, Sequence, Tuple

from ._expect import expect, shown
from ._glint import Material

Sliders = Mapping[str, Tuple[Any, str, float, float]]
"""By label: the object, its attribute, the lowest and the highest value."""

_PARTS = {"x": 0, "y": 1, "z": 2, "r": 0, "g": 1, "b": 2}


class Slider:
    """One number: an attribute of an object, a key of a mapping such as scene.settings, one of three numbers, or the factor of
    a material's color that its ambient, diffuse or specular is."""

    def __init__(self, label: str, owner: Any, name: str, lowest: float, highest: float) -> None:
        self.label = label
        self._owner = owner
        self._name, self._part = name, None  # type: Tuple[str, Optional[int]]
        before, dot, after = name.rpartition(".")
        if dot and after in _PARTS:
            self._name, self._part = before, _PARTS[after]
        for bound in (lowest, highest):
            if not isinstance(bound, numbers.Real) or isinstance(bound, bool) or not math.isfinite(bound):
                raise TypeError(f"sliders: {label!r}: expected finite numbers as bounds, found {shown(bound)}")
        if not lowest < highest:
            raise ValueError(f"sliders: {label!r}: expected a range such as 0, 2, found {lowest!r}, {highest!r}")
        self.lowest, self.highest = float(lowest), float(highest)
        try:
            value = self._read()
        except KeyError:
            raise ValueError(f"sliders: {label!r}: there is no {self._name!r} in {shown(owner)}") from None
        except (IndexError, TypeError):
            value = None  # no three numbers
        if not isinstance(value, numbers.Real) or isinstance(value, bool):
            hint = "; of three numbers, 'position.x' or 'color.r' is one" if self._part is None else ""
            raise TypeError(f"sliders: {label!r}: expected the name of a number, found {name!r}{hint}")
        self._is_whole = isinstance(value, numbers.Integral)
        self.step = 1.0 if self._is_whole else (self.highest - self.lowest) / 200

    def _whole_value(self) -> Any:
        is_mapping = isinstance(self._owner, MutableMapping)
        return self._owner[self._name] if is_mapping else getattr(self._owner, self._name)

    def _read(self) -> Any:
        value = self._whole_value()
        if self._part is not None:
            return value[self._part]
        if isinstance(self._owner, Material) and self._name in ("ambient", "diffuse", "specular"):
            return _factor(value, self._owner.color)
        return value

    @property
    def value(self) -> float:
        """What the scene has now, which may be out of the slider's range; its lowest if that is no finite number any more."""
        try:
            value = float(self._read())
        except (AttributeError, KeyError, IndexError, TypeError, ValueError):
            return self.lowest
        return value if math.isfinite(value) else self.lowest

    def set(self, value: float) -> None:
        """Changes the number, within the slider's range."""
        new: Any = min(max(value, self.lowest), self.highest)
        if self._is_whole:
            new = round(new)
        if self._part is not None:
            three = list(self._whole_value())
            three[self._part] = new
            new = tuple(three)
        if isinstance(self._owner, MutableMapping):
            self._owner[self._name] = new
        else:
            setattr(self._owner, self._name, new)


def _factor(value: Sequence[float], color: Sequence[float]) -> Optional[float]:
    """value / color; None if the channels differ in that."""
    most = max(color)
    factor = value[list(color).index(most)] / most if most > 0 else 0.0
    is_factor = all(math.isclose(v, factor * c, rel_tol=1e-6, abs_tol=1e-9) for v, c in zip(value, color))
    return factor if is_factor else None


def to_sliders(sliders: Optional[Sliders]) -> List[Slider]:
    """TypeError, ValueError or AttributeError if one of them is not a number with a range."""
    expect("sliders", sliders, Optional[Mapping[str, Any]])
    made = []
    for label, wanted in (sliders or {}).items():
        expect("sliders", label, str)
        if not isinstance(wanted, (tuple, list)) or len(wanted) != 4 or not isinstance(wanted[1], str):
            raise TypeError(f"sliders: {label!r}: expected (object, attribute, lowest, highest), found {shown(wanted)}")
        made.append(Slider(label, *wanted))
    return made
