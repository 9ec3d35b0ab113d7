# SPDX-License-Identifier: Apache-2.0
"""Messages about wrong arguments and names: what was expected, and what was found."""

from __future__ import annotations

import difflib
import functools
import inspect
import numbers
import os
import typing
from typing import Any, Callable, Iterable, TypeVar

import numpy as np

from ._hints import attribute_hint, keyword_hint, missing_hint

Function = TypeVar("Function", bound=Callable[..., Any])
# What pybind11 says of arguments that it cannot convert.
_NOT_FOR_USERS = ("incompatible function arguments", "incompatible constructor arguments", "Unable to cast")
_WORDS = {int: "a whole number", float: "a number", str: "a string", bool: "True or False", bytes: "bytes", type(None): "None"}


def shown(value: object) -> str:
    """repr(value), shortened."""
    text = repr(value)
    return text if len(text) <= 100 else text[:97] + "..."


def suggest(name: str, known: Iterable[str]) -> str:
    """'; did you mean 'background'?', or nothing if no name is similar."""
    near = difflib.get_close_matches(name, list(known), 1, 0.6)
    return f"; did you mean '{near[0]}'?" if near else ""


def unknown_attribute(owner: object, name: str) -> AttributeError:
    """The error for a name that a class does not have, with the one that was probably meant."""
    kind = type(owner)
    known = [known for known in dir(kind) if not known.startswith("_")]
    hint = next(filter(None, (attribute_hint(base.__name__, name) for base in kind.__mro__)), "")
    return AttributeError(f"{kind.__name__} has no attribute '{name}'{hint or suggest(name, known)}")


class Closed:
    """A class whose objects refuse attributes that it does not have. Classes derived from it by users take any."""

    if not typing.TYPE_CHECKING:  # type checkers would take any name

        def __setattr__(self, name: str, value: object) -> None:
            is_own = type(self).__module__.startswith("glint.")
            if is_own and not name.startswith("_") and not hasattr(type(self), name):
                raise unknown_attribute(self, name)
            object.__setattr__(self, name, value)

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            raise unknown_attribute(self, name)


def matches(value: object, hint: Any) -> bool:
    """Whether a value is of an annotated type; True where that cannot be told."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if hint is Any or isinstance(hint, (TypeVar, str)):
        return True
    if origin is typing.Union:
        return any(matches(value, part) for part in arguments)
    if origin is typing.Literal:
        return value in arguments
    if origin is tuple and Ellipsis not in arguments:
        return (
            isinstance(value, (tuple, list, np.ndarray))
            and len(value) == len(arguments)
            and all(map(matches, value, arguments))
        )
    kind = origin if origin is not None else hint
    if kind is int:
        return isinstance(value, numbers.Integral)
    if kind is float:
        return isinstance(value, numbers.Real)
    if not isinstance(kind, type):
        return True
    if arguments and isinstance(value, (list, tuple)) and len(arguments) == 1:
        return all(matches(item, arguments[0]) for item in value)
    return isinstance(value, kind)


def describe(hint: Any) -> str:
    """A type in words: 'a Material or None'."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Union:
        words = list(dict.fromkeys(describe(part) for part in arguments))
        return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 2 else words)
    if origin is typing.Literal:
        return ("one of " if len(arguments) > 1 else "") + ", ".join(map(repr, arguments))
    if origin is tuple and Ellipsis not in arguments:
        return f"({', '.join('int' if part is int else describe(part) for part in arguments)})"
    kind = origin if origin is not None else hint
    if kind in _WORDS:
        return _WORDS[kind]
    if kind is os.PathLike:
        return "a path"
    name = str(getattr(kind, "__name__", kind))
    if arguments and origin is not None:
        return f"a {name.lower()} of {describe(arguments[0])}"
    return f"{'an' if name[0] in 'AEIO' else 'a'} {name}"


def expect(name: str, value: object, hint: Any) -> None:
    """TypeError if the value is not of the type."""
    if not matches(value, hint):
        raise TypeError(f"{name}: expected {describe(hint)}, found {shown(value)}")


def _wrong_argument(function: Callable[..., Any], arguments: Any, keywords: Any) -> TypeError:
    hints = typing.get_type_hints(function)
    bound = inspect.signature(function).bind(*arguments, **keywords).arguments
    for name, value in bound.items():
        several = value if name == "paths" else (value,)
        for one in several:
            if name in hints and not matches(one, hints[name]):
                return TypeError(f"{name}: expected {describe(hints[name])}, found {shown(one)}")
    given = ", ".join(f"{name}={shown(value)}" for name, value in bound.items() if name != "self")
    return TypeError(f"{function.__name__}(): an argument is of a wrong type: {given}")


def _wrong_call(function: Callable[..., Any], arguments: Any, keywords: Any) -> str:
    """Why a function cannot be called with these arguments; nothing if it can."""
    signature = inspect.signature(function)
    try:
        signature.bind(*arguments, **keywords)
        return ""
    except TypeError as error:
        said = str(error)
    name = function.__name__
    parameters = list(signature.parameters.values())
    names = [parameter.name for parameter in parameters]
    for keyword in keywords:
        if keyword not in names:
            return f"{name}() has no keyword '{keyword}'{keyword_hint(keyword, ' '.join(names)) or suggest(keyword, names)}"
    positional = [parameter.name for parameter in parameters if parameter.kind is parameter.POSITIONAL_OR_KEYWORD]
    if len(arguments) > len(positional):
        taken = [parameter for parameter in positional if parameter != "self"]
        takes = f"{', '.join(taken)} and then keywords" if taken else f"keywords only, such as {names[len(positional)]}="
        return f"{name}() takes {takes}; found {shown(arguments[len(positional)])} without a keyword"
    return f"{name}(): {said}{missing_hint(name) if said.startswith('missing') else ''}"


def _sizes(function: Callable[..., Any], arguments: Any, keywords: Any) -> str:
    """Of the arguments that are arrays: ' for centers of 1000000 x 3 numbers'."""
    bound = inspect.signature(function).bind(*arguments, **keywords).arguments
    shapes = {name: np.shape(value) for name, value in bound.items() if isinstance(value, (np.ndarray, list, tuple))}
    sizes = [f"{name} of {' x '.join(map(str, shape))} numbers" for name, shape in shapes.items() if shape]
    return " for " + ", ".join(sizes) if sizes else ""


def plain(function: Function) -> Function:
    """Says which argument of a public function is of a wrong type, in place of what pybind11 says."""

    @functools.wraps(function)
    def checked(*arguments: Any, **keywords: Any) -> Any:
        try:
            return function(*arguments, **keywords)
        except (TypeError, RuntimeError) as error:
            wrong = _wrong_call(function, arguments, keywords) if isinstance(error, TypeError) else ""
            if wrong:
                raise TypeError(wrong) from None
            if not any(words in str(error) for words in _NOT_FOR_USERS):
                raise
        except MemoryError as error:
            if "bad_alloc" not in str(error):
                raise  # it has a message
            raise MemoryError(f"{function.__name__}(): out of memory{_sizes(function, arguments, keywords)}") from None
        raise _wrong_argument(function, arguments, keywords)

    return checked  # type: ignore[return-value]
