# SPDX-License-Identifier: Apache-2.0
"""Conventions and render settings as mappings. docs/conventions.md explains each key."""

from __future__ import annotations

import operator
import re
from typing import Any, Dict, Iterator, List, Mapping, MutableMapping, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _glint
from ._expect import suggest

Setting = Union[bool, int, float, str, Tuple[int, int]]
"""A value: a bool, a number, a word ('phong'), or a size (width, height) in pixels."""


class SettingInfo(NamedTuple):
    """What a key takes, and what it means."""

    name: str
    values: str
    description: str
    is_convention: bool


setting_infos: Dict[str, SettingInfo] = {key[0]: SettingInfo(*key) for key in _glint.setting_keys()}
"""All keys of `scene.conventions` and `scene.settings`."""


def to_text(value: object) -> str:
    """As the command line has it: True -> 'true', (640, 480) -> '640x480'."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (tuple, list, np.ndarray)) and len(value) == 2:
        return f"{value[0]}x{value[1]}"
    if isinstance(value, float):
        return repr(float(value))  # NumPy 2 shows its own as np.float64(1.0)
    return str(value)


def from_text(key: str, text: str) -> Setting:
    if text in ("true", "false"):
        return text == "true"
    if key == "size":
        width, height = text.split("x")
        return int(width), int(height)
    if setting_infos[key].values.startswith("a whole number"):
        return int(text) if text.isdigit() else text
    try:
        return float(text)
    except ValueError:
        return text


def to_list(settings: Mapping[str, object]) -> List[Tuple[str, str]]:
    """Of those that are not None."""
    return [(key, to_text(value)) for key, value in settings.items() if value is not None]


def to_crop(crop: Any) -> Optional[Tuple[int, int, int, int]]:
    """(width, height, x, y), also of 'WIDTHxHEIGHT+X+Y', as the command has it."""
    if crop is None:
        return None
    values = crop
    if isinstance(crop, str):
        found = re.fullmatch(r"(\d+)x(\d+)\+(\d+)\+(\d+)", crop)
        values = found.groups() if found else ()
    try:
        width, height, x, y = (int(v) if isinstance(crop, str) else operator.index(v) for v in values)
    except (TypeError, ValueError):
        raise ValueError(
            "crop: expected (width, height, x, y), four whole numbers of pixels, or 'WIDTHxHEIGHT+X+Y', "
            f"found {crop!r}"
        ) from None
    if width <= 0 or height <= 0:
        raise ValueError(f"crop: expected (width, height, x, y) with a width and a height above 0, found {crop!r}")
    return width, height, x, y


class Settings(MutableMapping[str, Any]):
    """The scene's settings, or its conventions: scene.settings['size'] = (320, 240)."""

    def __init__(self, state: _glint.SceneState, conventions: bool) -> None:
        self._state = state
        self._keys = [i.name for i in setting_infos.values() if i.is_convention == conventions]

    def __getitem__(self, key: str) -> Any:
        if key not in self._keys:
            raise KeyError(f"there is no setting '{key}'{suggest(key, self._keys)}")
        return from_text(key, self._state.get_setting(key))

    def __setitem__(self, key: str, value: Any) -> None:
        self._state.set_setting(key, to_text(value))

    def __delitem__(self, key: str) -> None:
        raise TypeError("a setting cannot be deleted")

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)

    def __reduce__(self) -> Tuple[Any, ...]:
        return dict, (dict(self),)  # without the scene

    def __repr__(self) -> str:
        return repr(dict(self))


class _Profiles(Mapping[str, Mapping[str, Any]]):
    """The conventions and settings of each source, by its name: glint.profiles['epfl']['limit']."""

    def __init__(self) -> None:
        self._known: Dict[str, Optional[Dict[str, Setting]]] = dict.fromkeys(_glint.profile_names())

    def __getitem__(self, name: str) -> Mapping[str, Any]:
        profile = self._known[name]
        if profile is None:
            state = _glint.SceneState()
            state.apply_profile(name)
            profile = {key: from_text(key, state.get_setting(key)) for key in setting_infos}
            self._known[name] = profile
        return dict(profile)

    def __iter__(self) -> Iterator[str]:
        return iter(self._known)

    def __len__(self) -> int:
        return len(self._known)

    def __repr__(self) -> str:
        return f"glint.profiles({', '.join(self._known)})"


profiles: Mapping[str, Mapping[str, Any]] = _Profiles()
"""Each source's conventions and settings: a mapping of mappings, which cannot be changed."""
