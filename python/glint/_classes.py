# SPDX-License-Identifier: Apache-2.0
"""What the extension module's classes lack: signatures, plain errors, pickling."""

from __future__ import annotations

import inspect
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from . import _glint
from ._expect import expect, shown, suggest, unknown_attribute
from ._hints import attribute_hint

_COMMON = ("material", "color", "transform", "name")
_POSITIONAL: Dict[Any, Tuple[str, ...]] = {
    _glint.Light: ("kind",),
    _glint.Fog: ("kind",),
    _glint.Occlusion: ("method",),
    _glint.BackgroundGradient: ("kind",),
    _glint.Texture: ("image", "color_map"),
    _glint.Material: (),
    _glint.Camera: (),
    _glint.CameraFrame: (),
    _glint.Mesh: ("vertices", "triangles", "normals", "colors", "texture_coordinates"),
}
_SHAPES = (
    _glint.Sphere, _glint.Plane, _glint.Cylinder, _glint.Cone, _glint.Disc, _glint.Box, _glint.Triangle,
    _glint.SmoothTriangle, _glint.Polygon, _glint.Mesh, _glint.Torus, _glint.Quadric, _glint.Quartic,
    _glint.Solid,
)  # fmt: skip
_REQUIRED = {_glint.Polygon: ("vertices",), _glint.Mesh: ("vertices", "triangles"), _glint.Solid: ("operation", "parts")}
# Types that the extension module converts without a message of its own.
_TYPES: Dict[str, Any] = {
    "name": str,
    "file": str,
    "kind": str,
    "method": str,
    "operation": str,
    "projection": str,
    "fov_axis": str,
    "material": Optional[_glint.Material],
    "frame": Optional[_glint.CameraFrame],
    "texture": Optional[_glint.Texture],
    "over": Optional[_glint.Texture],
    "caps": bool,
}


class _Shown(str):
    """A default in words, for help()."""

    def __repr__(self) -> str:
        return str(self)


def _fields(cls: Any) -> List[str]:
    """The attributes that can be set, in the order of the tables."""
    return [name for name, value in vars(cls).items() if isinstance(value, property) and value.fset is not None]


def _usual(cls: Any) -> Any:
    """An object with the defaults."""
    if cls is _glint.Texture:
        return cls(np.zeros((1, 1, 3), np.uint8))
    if cls is _glint.Polygon:
        return cls([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    if cls is _glint.Solid:
        return cls("merge", [_glint.Sphere()])
    if cls is _glint.Mesh:
        return None
    return cls()


def _default(cls: Any, usual: Any, name: str) -> Any:
    if name in _REQUIRED.get(cls, ()):
        return inspect.Parameter.empty
    if cls is _glint.Light and name == "specular_color":
        return _Shown("<color>")
    if cls is _glint.Mesh or name in ("image", "world_from_texture", "transform"):
        return "" if name == "name" else None
    value = getattr(usual, name)
    if cls is _glint.Material and isinstance(value, tuple) and name != "color":
        if any(value) and not any(getattr(cls(color=0), name)):
            return round(value[0] / usual.color[0], 12)  # a factor of the color
    return _Shown(repr(value.tolist())) if isinstance(value, np.ndarray) else value


def _signature(cls: Any) -> inspect.Signature:
    usual = _usual(cls)
    positional = _POSITIONAL.get(cls, tuple(_fields(cls)))
    others = [name for name in _fields(cls) if name not in (*positional, "file")]
    if cls in _SHAPES:
        others += [name for name in _COMMON if name not in others]
    kinds = inspect.Parameter
    parameters = [kinds("self", kinds.POSITIONAL_OR_KEYWORD)]
    for name in (*positional, *others):
        kind = kinds.POSITIONAL_OR_KEYWORD if name in positional else kinds.KEYWORD_ONLY
        parameters.append(kinds(name, kind, default=_default(cls, usual, name)))
    return inspect.Signature(parameters)


def check_normals(normals: Any) -> None:
    """Refuses normals without a direction; the extension module refuses what are no normals at all."""
    try:
        rows = np.asarray(normals, dtype=float)
    except (TypeError, ValueError):
        return
    if rows.ndim == 0 or rows.shape[-1] != 3 or not rows.size:
        return
    zero = np.flatnonzero(~rows.reshape(-1, 3).any(axis=1))
    if zero.size:
        raise ValueError(f"normals: row {zero[0]}: expected a normal of any length but 0, found (0, 0, 0)")


def _check(cls: Any, name: str, value: Any) -> None:
    hint = _TYPES.get(name)
    if hint is not None and not (hint is bool and isinstance(value, (int, np.bool_))):
        expect(name, value, hint)
    if name == "normals" and cls in (_glint.SmoothTriangle, _glint.Mesh):
        check_normals(value)


def _complete(cls: Any) -> None:
    name = cls.__name__
    signature = _signature(cls)
    names = [p.name for p in list(signature.parameters.values())[1:]]
    positional = [p.name for p in signature.parameters.values() if p.kind is p.POSITIONAL_OR_KEYWORD][1:]
    required = _REQUIRED.get(cls, ())
    checked = frozenset(n for n in names if n in _TYPES or n == "normals")
    construct, set_attribute, represent = cls.__init__, cls.__setattr__, cls.__repr__
    example = f"{names[0]}={signature.parameters[names[0]].default!r}"

    def __init__(self: Any, *values: Any, **keywords: Any) -> None:
        if len(values) > len(positional):
            found = shown(values[len(positional)])
            if not positional:
                raise TypeError(f"{name}() takes keywords only, such as {example}; found {found} without a keyword")
            raise TypeError(
                f"{name}() takes {', '.join(positional)} and then keywords; found {found} without a keyword"
            )
        for key, value in zip(positional, values):
            if key in keywords:
                raise TypeError(f"{name}() has two values for '{key}': {shown(value)} and {shown(keywords[key])}")
            if key in checked:
                _check(cls, key, value)
        for key, value in keywords.items():
            if key not in names:
                raise TypeError(f"{name} has no attribute '{key}'{attribute_hint(name, key) or suggest(key, names)}")
            if key in checked:
                _check(cls, key, value)
        for key in required[len(values):]:
            if key not in keywords:
                raise TypeError(f"{name}() needs {' and '.join(required)}; '{key}' is missing")
        construct(self, *values, **keywords)

    def __setattr__(self: Any, key: str, value: Any) -> None:
        if key in checked:
            _check(cls, key, value)
        try:
            set_attribute(self, key, value)
        except AttributeError:
            if isinstance(getattr(type(self), key, None), property):
                raise AttributeError(f"{name} cannot change its attribute '{key}'") from None
            raise unknown_attribute(self, key) from None

    def __getattr__(self: Any, key: str) -> Any:
        if key.startswith("_"):
            raise AttributeError(key)
        raise unknown_attribute(self, key)

    def __repr__(self: Any) -> str:
        # Debuggers show objects whose constructor failed.
        return str(represent(self)) if _glint.has_values(self) else f"<{name} without values>"

    def __reduce_ex__(self: Any, protocol: int) -> Tuple[Any, ...]:
        return _rebuild, (type(self), *_state(cls, self)), getattr(self, "__dict__", None) or None

    __init__.__signature__ = signature  # type: ignore[attr-defined]
    lines = [f"{n}: {getattr(cls, n).__doc__}" for n in names if getattr(cls, n, None) is not None]
    __init__.__doc__ = "\n".join(lines)
    for function in (__init__, __setattr__, __getattr__, __repr__, __reduce_ex__):
        function.__qualname__ = f"{name}.{function.__name__}"
        setattr(cls, function.__name__, function)
    cls.__module__ = "glint"


def _state(cls: Any, item: Any) -> Tuple[Tuple[Any, ...], Dict[str, Any]]:
    """The arguments of a call that makes an equal object, and the attributes to set then."""
    common = {name: getattr(item, name) for name in _COMMON} if cls in _SHAPES else {}
    if cls is _glint.Mesh:
        values = tuple(getattr(item, name) for name in _POSITIONAL[cls])
        try:
            is_whole = _glint.Mesh(*values, **common) == item
        except ValueError:  # normals are numbered in another way than vertices
            is_whole = False
        return (values, common) if is_whole else ((_text_of(item),), common)
    fields = {name: getattr(item, name) for name in _fields(cls) if name != "intensity"}
    fields.update(common)
    first = _POSITIONAL[cls] if cls is _glint.Texture else _REQUIRED.get(cls, ())
    values = tuple(fields.pop(name) for name in first)
    return values, fields


def _text_of(mesh: Any) -> str:
    state = _glint.SceneState()
    state.add_shape(mesh)
    return state.write_whole_glint()


def _rebuild(cls: Any, values: Tuple[Any, ...], fields: Dict[str, Any]) -> Any:
    if issubclass(cls, _glint.Mesh) and len(values) == 1:
        from ._scene import _unpickled

        mesh = _unpickled(values[0]).shapes[0]
        for name, value in fields.items():
            setattr(mesh, name, value)
        return mesh
    item = cls.__new__(cls)
    base = next(base for base in cls.__mro__ if base.__module__ == "glint" and "__init__" in vars(base))
    base.__init__(item, *values)
    for name, value in fields.items():
        setattr(item, name, value)
    return item


def complete_classes() -> None:
    """Once, when the package is imported."""
    for cls in (*_POSITIONAL, *(shape for shape in _SHAPES if shape not in _POSITIONAL)):
        _complete(cls)
