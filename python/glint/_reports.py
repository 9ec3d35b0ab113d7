# SPDX-License-Identifier: Apache-2.0
"""Answers as objects and as text."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, Mapping, Optional, Tuple

from ._html import Bytes
from ._html_answers import comparison_html
from ._html_pixel import PixelView, explanation_html
from ._image import Image
from ._values import Color, Vec3

_POINTS = {"origin", "direction", "point", "normal", "to_eye", "to_light"}


def _convert(key: str, value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list):
        if len(value) == 3 and all(isinstance(x, (int, float)) for x in value) and key != "bytes":
            return Vec3(*value) if key in _POINTS else Color(*value)
        return [_convert(key, item) for item in value]
    return value


class Record(Mapping[str, Any]):
    """Values by name, as attributes or as items. `data` has them as JSON does."""

    def __init__(self, data: Dict[str, Any]) -> None:
        self.data = data

    def __getitem__(self, key: str) -> Any:
        return _convert(key, self.data[key])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or name == "data":
            raise AttributeError(name)
        if name not in self.data:
            raise AttributeError(f"there is no {name!r}; there are {', '.join(self.data)}")
        return self[name]

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *self.data]

    def __iter__(self) -> Iterator[str]:
        return iter(self.data)

    def __len__(self) -> int:
        return len(self.data)

    def __repr__(self) -> str:
        shown = (f"{key}={'...' if isinstance(value, (Record, list)) else repr(value)}" for key, value in self.items())
        return f"{type(self).__name__}({', '.join(shown)})"


class _Report(Record):
    """A record, and the text that the command prints."""

    def __init__(self, data: Dict[str, Any], text: str) -> None:
        super().__init__(data)
        self.text = text

    def __str__(self) -> str:
        return self.text


class Explanation(_Report):
    """Why a pixel has its color: `value`, `layers` and `rays` (docs/explain.md has all names), and `text`.

    A notebook shows the picture with the pixel marked, and the terms as bars. The picture is rendered then; if the
    scene has been changed since, or the explanation comes from another process, there is none.
    """

    _view: Optional[PixelView] = None
    _sample: Optional[int] = None

    def _repr_html_(self) -> str:
        pictures = self._view.draw(self.data["value"]) if self._view is not None and "value" in self.data else ""
        return explanation_html(self.data, self.text, self._sample, pictures)

    def __getstate__(self) -> Dict[str, Any]:
        return {key: value for key, value in self.__dict__.items() if key != "_view"}


class Comparison(_Report):
    """How two pictures differ: `identical`, `mean`, `psnr`, `largest` ... (docs/compare.md), and `text`.

    A notebook shows both pictures and their difference, made smaller.
    """

    difference: Image
    """Of the pictures, by channel; the largest difference is 1."""
    _shown: Tuple[Bytes, ...] = ()

    def _repr_html_(self) -> str:
        return comparison_html(self.data, self.text, self.causes, self._shown)

    @property
    def causes(self) -> List[Any]:
        """The likely causes, the best first: `name`, `explanation`, `explained`, `perhaps`."""
        diagnosis = self.data.get("diagnosis")
        return [Record(cause) for cause in diagnosis["causes"]] if diagnosis else []
