# SPDX-License-Identifier: Apache-2.0
"""The scene's lights, materials, textures and shapes as sequences."""

from __future__ import annotations

import operator
from typing import Any, Generic, List, MutableSequence, Sequence, Tuple, TypeVar, Union, overload

import numpy as np

from . import _glint
from ._expect import expect
from ._glint import Light, Material, Shape, Texture
from ._shape_arrays import Numbers, ShapeArrays, ShapeSelection, numbers_of

Item = TypeVar("Item")


class _Items(Sequence[Item], Generic[Item]):
    """Items by number or by name."""

    _what = ""

    def __init__(self, state: _glint.SceneState) -> None:
        self._state = state

    def _get(self, index: int) -> Item:
        return getattr(self._state, self._what)(index)  # type: ignore[no-any-return]

    def __len__(self) -> int:
        return getattr(self._state, self._what + "_count")()  # type: ignore[no-any-return]

    def _index(self, index: int) -> int:
        number = operator.index(index)
        count = len(self)
        if not -count <= number < count:
            raise IndexError(f"there is no {self._what} {number}: the scene has {count}")
        return number % count

    @overload
    def __getitem__(self, key: Union[int, str]) -> Item: ...
    @overload
    def __getitem__(self, key: slice) -> List[Item]: ...

    def __getitem__(self, key: Union[int, str, slice]) -> Union[Item, List[Item]]:
        if isinstance(key, str):
            return getattr(self._state, self._what + "_named")(key)  # type: ignore[no-any-return]
        if isinstance(key, slice):
            return [self._get(i) for i in range(*key.indices(len(self)))]
        return self._get(self._index(key))

    def __reduce__(self) -> Tuple[Any, ...]:
        return list, (list(self),)  # without the scene

    def __contains__(self, item: object) -> bool:
        if isinstance(item, str):
            return any(getattr(known, "name", None) == item for known in self)
        return any(known == item for known in self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and list(self) == list(other)

    def __repr__(self) -> str:
        count = len(self)
        shown = ", ".join(repr(self._get(i)) for i in range(min(count, 20)))
        return f"[{shown}{', ... ' + str(count - 20) + ' more' if count > 20 else ''}]"


class Lights(_Items[Light], MutableSequence[Light]):
    """The scene's lights, by number or by name: a list that can be changed."""

    _what = "light"

    def _all(self) -> List[Light]:
        return [self._get(i) for i in range(len(self))]

    def __setitem__(self, key: Any, value: Any) -> None:
        lights = self._all()
        if isinstance(key, str):
            key = lights.index(self[key])
        for light in value if isinstance(key, slice) else (value,):
            expect("lights", light, Light)
        lights[key] = value
        self._state.set_lights(lights)

    def __delitem__(self, key: Any) -> None:
        lights = self._all()
        if isinstance(key, str):
            key = lights.index(self[key])
        del lights[key]
        self._state.set_lights(lights)

    def insert(self, index: int, value: Light) -> None:
        """Adds a light before the one of this number."""
        lights = self._all()
        expect("lights", value, Light)
        lights.insert(index, value)
        self._state.set_lights(lights)


class Materials(_Items[Material]):
    """The scene's materials, by number or by name. Materials are added, or come with shapes; none is removed."""

    _what = "material"

    def __setitem__(self, key: Union[int, str], value: Material) -> None:
        """Another material for all shapes that have this one."""
        index = [m.name for m in self].index(key) if isinstance(key, str) else self._index(key)
        expect("materials", value, Material)
        self._state.set_material(index, value)

    def append(self, value: Material) -> None:
        """Adds a material."""
        expect("materials", value, Material)
        self._state.add_material(value)


class Textures(_Items[Texture]):
    """The scene's textures, by number or by name. Textures are added, or come with materials; none is removed."""

    _what = "texture"

    def append(self, value: Texture) -> None:
        """Adds a texture."""
        expect("textures", value, Texture)
        self._state.add_texture(value)


class Shapes(ShapeArrays, _Items[Any]):
    """The scene's shapes, by number or by name: Spheres, Planes ... (for type checkers Any). A slice, a range, an array of
    numbers or a mask chooses several: scene.shapes[numbers].centers. scene.shapes.centers is that of all shapes."""

    _what = "shape"

    def _numbers(self) -> Numbers:
        return np.arange(len(self), dtype=np.int64)

    @overload  # type: ignore[override]  # a slice is no list
    def __getitem__(self, key: Union[int, str]) -> Any: ...
    @overload
    def __getitem__(self, key: Any) -> ShapeSelection: ...

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str) or hasattr(key, "__index__") and np.ndim(key) == 0:
            return super().__getitem__(key)
        return ShapeSelection(self._state, numbers_of(key, len(self)))

    def __setitem__(self, key: Union[int, str], value: Shape) -> None:
        index = [s.name for s in self].index(key) if isinstance(key, str) else self._index(key)
        expect("shapes", value, Shape)
        self._state.set_shape(index, value)

    def __delitem__(self, key: Any) -> None:
        if isinstance(key, str):
            numbers = [[s.name for s in self].index(key)]
        elif hasattr(key, "__index__") and np.ndim(key) == 0:
            numbers = [self._index(key)]
        else:
            numbers = numbers_of(key, len(self)).tolist()
        self._state.remove_shapes(numbers)

    def append(self, value: Shape) -> None:
        """Adds a shape."""
        expect("shapes", value, Shape)
        self._state.add_shape(value)

    def clear(self) -> None:
        """Removes all shapes."""
        del self[:]
