# SPDX-License-Identifier: Apache-2.0
"""Attributes of many shapes as arrays: scene.shapes.centers, scene.shapes[numbers].colors."""

from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _glint
from ._colors import colors_of
from ._expect import Closed, shown
from ._glint import Material

Floats = npt.NDArray[np.float64]
Numbers = npt.NDArray[np.int64]


class _Array:
    """An attribute of shapes. Unlike a property it may take, for type checkers, more than it gives."""

    def __init__(self, what: str, doc: str, *name: str) -> None:
        self._what, self._name, self.__doc__ = what, name, doc

    @overload
    def __get__(self, owner: None, kind: Optional[type] = None) -> _Array: ...
    @overload
    def __get__(self, owner: ShapeArrays, kind: Optional[type] = None) -> Floats: ...

    def __get__(self, owner: Optional[ShapeArrays], kind: Optional[type] = None) -> Union[_Array, Floats]:
        if owner is None:
            return self
        return getattr(owner._state, "shape_" + self._what)(owner._numbers(), *self._name)  # type: ignore[no-any-return]

    def __set__(self, owner: ShapeArrays, value: Any) -> None:
        getattr(owner._state, "set_shape_" + self._what)(owner._numbers(), *self._name, self._given(value))

    def _given(self, value: Any) -> Any:
        return value


class _Colors(_Array):
    def _given(self, value: Any) -> Any:
        return colors_of(value, None, None, None, None, None, 0.5)


class _Materials:
    """N Materials; None for the default one. Set from N of them or one for all."""

    @overload
    def __get__(self, owner: None, kind: Optional[type] = None) -> _Materials: ...
    @overload
    def __get__(self, owner: ShapeArrays, kind: Optional[type] = None) -> List[Optional[Material]]: ...

    def __get__(
        self, owner: Optional[ShapeArrays], kind: Optional[type] = None
    ) -> Union[_Materials, List[Optional[Material]]]:
        return self if owner is None else owner._state.shape_materials(owner._numbers())

    def __set__(self, owner: ShapeArrays, value: Union[None, Material, Sequence[Optional[Material]]]) -> None:
        numbers = owner._numbers()
        given = [value] if value is None or isinstance(value, Material) else value
        if not isinstance(given, (list, tuple, np.ndarray)):
            raise TypeError(f"materials: expected a Material, None or one for each shape, found {shown(value)}")
        if given is value and len(given) != len(numbers):
            raise ValueError(f"materials: expected one Material or {len(numbers)}, found {len(given)}")
        for i, material in enumerate(given):
            if material is not None and not isinstance(material, Material):
                raise TypeError(f"materials[{i}]: expected a Material or None, found {shown(material)}")
        owner._state.set_shape_materials(numbers, list(given))


class ShapeArrays(Closed):
    """Reading makes a new array. An assignment changes all these shapes at once, without an object for each; the next
    picture updates the hierarchy once. What is wrong is refused before anything changes."""

    _state: _glint.SceneState

    def _numbers(self) -> Numbers:
        raise NotImplementedError

    centers = _Array("parameters", "Of spheres, discs and tori: (N, 3), in the scene's units.", "centers")
    radii = _Array("parameters", "Of spheres, cylinders, discs and tori: (N,), > 0; one number is for all.", "radii")
    from_ = _Array("parameters", "Of cylinders and cones: (N, 3), where the axes begin.", "from_")
    to = _Array("parameters", "Of cylinders and cones: (N, 3), where the axes end.", "to")
    vertices = _Array("parameters", "Of triangles and smooth triangles: (N, 3, 3).", "vertices")
    normals = _Array("parameters", "Of smooth triangles: (N, 3, 3).", "normals")
    colors = _Colors(
        "colors",
        "(N, 3): the shapes' own colors, in single precision; NaN for a shape without one, which has its material's. "
        "Set from (N, 3), N names or one color for all; of uint8, 255 is 1. None: the materials' colors.",
    )
    transforms = _Array(
        "transforms", "(N, 3, 4): world from object. Set from (N, 3, 4), (N, 4, 4) or one matrix for all; None: the identity."
    )
    materials = _Materials()


class ShapeSelection(ShapeArrays, Sequence[Any]):
    """Some shapes of a scene, by their numbers: scene.shapes[10:20], scene.shapes[numbers] or scene.shapes[mask].

    A sequence of shapes, and their attributes as arrays. It refers to the scene: list(selection) has the shapes
    themselves. When shapes have been removed from the scene, the others have new numbers, and it is refused.
    """

    def __init__(self, state: _glint.SceneState, numbers: Numbers) -> None:
        self._state = state
        self._chosen = numbers
        self._removals = state.removals()

    def _numbers(self) -> Numbers:
        if self._state.removals() != self._removals:
            raise RuntimeError("shapes were removed from the scene, so the numbers of others have changed: select again")
        return self._chosen

    def __len__(self) -> int:
        return len(self._chosen)

    @overload
    def __getitem__(self, key: int) -> Any: ...
    @overload
    def __getitem__(self, key: Any) -> Any: ...

    def __getitem__(self, key: Any) -> Any:
        """The shape at a place of the selection, or the selection of several."""
        chosen = self._numbers()[key]
        if isinstance(chosen, np.ndarray):
            return ShapeSelection(self._state, chosen)
        return self._state.shape(int(chosen))

    def __add__(self, other: Sequence[Any]) -> List[Any]:
        return list(self) + list(other)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and list(self) == list(other)

    def __reduce__(self) -> Tuple[Any, ...]:
        return list, (list(self),)  # without the scene

    def __repr__(self) -> str:
        shown_shapes = ", ".join(repr(self[i]) for i in range(min(len(self), 20)))
        return f"[{shown_shapes}{', ... ' + str(len(self) - 20) + ' more' if len(self) > 20 else ''}]"


def numbers_of(key: Any, count: int) -> Numbers:
    """The numbers of items that a slice, a range, an array of numbers or a mask chooses of `count`."""
    if isinstance(key, slice):
        return np.arange(*key.indices(count), dtype=np.int64)
    try:
        numbers = np.arange(key.start, key.stop, key.step) if isinstance(key, range) else np.asarray(key)
        if numbers.size == 0 and numbers.ndim == 1:
            numbers = numbers.astype(np.int64)
        is_right = numbers.ndim == 1 and numbers.dtype.kind in "iub"
    except (TypeError, ValueError, OverflowError):
        is_right = False
    if not is_right:
        raise TypeError(f"shapes: expected a number, a name, a slice, a range, an array of numbers or a mask, found {shown(key)}")
    if numbers.dtype.kind == "b":
        if len(numbers) != count:
            raise IndexError(f"the mask has {len(numbers)} values, the scene has {count} shapes")
        return np.flatnonzero(numbers).astype(np.int64)
    numbers = numbers.astype(np.int64)
    outside = (numbers < -count) | (numbers >= count)
    if outside.any():
        raise IndexError(f"there is no shape {numbers[outside][0]}: the scene has {count}")
    return np.where(numbers < 0, numbers + count, numbers)
