# SPDX-License-Identifier: Apache-2.0
"""Colors of names and of data: the scale that gives each value its color."""

from __future__ import annotations

import copy
import re
from typing import Any, Callable, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._color_names import COLOR_NAMES
from ._errors import warn_of
from ._expect import shown, suggest
from ._image import Image
from ._values import Color, ColorLike

Array = npt.NDArray[Any]
Norm = Union[None, str, Callable[..., Any]]
"""None or 'linear', 'log', or a norm of matplotlib."""
Colormap = Union[str, Callable[..., Any]]
"""A name of matplotlib's, or a function of values from 0 to 1 that gives (N, 3) or (N, 4) colors."""


def named_color(text: str) -> Optional[Tuple[float, float, float]]:
    """'red', '#f00', '#ff0000' or '#ff0000ff' (the alpha is left out); None of other words."""
    word = text.strip().lower()
    digits = COLOR_NAMES.get(word.replace(" ", ""), word[1:] if word.startswith("#") else "")
    if not re.fullmatch("[0-9a-f]{3}|[0-9a-f]{4}|[0-9a-f]{6}|[0-9a-f]{8}", digits):
        return None
    if len(digits) < 6:
        digits = "".join(2 * digit for digit in digits)
    red, green, blue = (int(digits[i:i + 2], 16) / 255 for i in (0, 2, 4))
    return red, green, blue


def to_color(name: str, color: ColorLike) -> Color:
    """Of all that is a color."""
    if isinstance(color, str):
        found = named_color(color)
        if found is None:
            raise ValueError(f"{name}: expected a color such as 'red' or '#ff0000', found {shown(color)}")
        return Color(*found)
    channels = np.asarray(color)
    if channels.dtype.kind not in "uif" or channels.shape not in ((), (3,), (4,)):
        raise ValueError(f"{name}: expected three numbers, one for grey, or a name, found {shown(color)}")
    scaled = channels / 255 if channels.dtype == np.uint8 else channels.astype(float)
    return Color(*(np.repeat(scaled, 3) if scaled.ndim == 0 else scaled[:3]).tolist())


def find_colormap(colormap: Colormap) -> Callable[..., Any]:
    if not isinstance(colormap, str):
        if not callable(colormap):
            raise TypeError(f"colormap: expected a name or a colormap of matplotlib, found {shown(colormap)}")
        return colormap
    try:
        import matplotlib  # type: ignore[import]
    except ImportError:
        raise ImportError(f"the colormap {colormap!r} is one of matplotlib's, which is not installed") from None
    try:
        return matplotlib.colormaps[colormap]  # type: ignore[no-any-return]
    except KeyError:
        raise ValueError(f"colormap: matplotlib has no colormap {colormap!r}{suggest(colormap, matplotlib.colormaps)}") from None


class ColorScale:
    """Colors for numbers: ColorScale(values, 'viridis', vmin=0).

    values: numbers of any shape, whose range is the scale's; colormap: matplotlib's, its name, or a function of
    numbers from 0 to 1; vmin, vmax: the ends of the range, in the place of the least and the greatest value. Values
    beyond them have the colors of the ends. norm: None or 'linear'; 'log', for values > 0; or a norm of matplotlib,
    which has vmin and vmax itself. nan_color: of values that are NaN or, with 'log', not > 0. NaN and infinity do
    not count for the range.

    scale(values) gives the colors, (..., 3); `colormap=scale` of Scene.spheres() uses the scale for several calls;
    scale.bar() is its picture, and scale.mappable() is for matplotlib's figure.colorbar().
    """

    def __init__(
        self,
        values: Any = (),
        colormap: Colormap = "viridis",
        *,
        vmin: Optional[float] = None,
        vmax: Optional[float] = None,
        norm: Norm = None,
        nan_color: ColorLike = 0.5,
    ) -> None:
        self.nan_color = to_color("nan_color", nan_color)
        self.colormap = colormap
        self._map = find_colormap(colormap)
        self._norm = copy.copy(norm) if callable(norm) else None
        self.is_log = norm == "log"
        if not callable(norm) and norm not in (None, "linear", "log"):
            raise ValueError(f"norm: expected 'linear', 'log' or a norm of matplotlib, found {shown(norm)}")
        if self._norm is not None and not (vmin is None and vmax is None):
            raise ValueError("vmin and vmax are those of the norm: give them to the norm")
        known = _numbers(values)
        known = known[np.isfinite(known) & ((known > 0) | (not self.is_log))]
        if self._norm is not None:
            if hasattr(self._norm, "autoscale_None"):
                self._norm.autoscale_None(known)  # changes the copy
            vmin, vmax = getattr(self._norm, "vmin", None), getattr(self._norm, "vmax", None)
        least = float(known.min()) if known.size else (0.0 if vmax is None else min(0.0, float(vmax)))
        self.vmin = float(vmin) if vmin is not None else least
        self.vmax = float(vmax) if vmax is not None else max(float(known.max()) if known.size else 1.0, self.vmin)
        if not (np.isfinite(self.vmin) and np.isfinite(self.vmax) and self.vmin <= self.vmax):
            raise ValueError(f"vmin and vmax: expected vmin <= vmax, found {self.vmin} and {self.vmax}")
        if self.is_log and not self.vmin > 0:
            raise ValueError(f"vmin: expected a number > 0 with norm='log', found {self.vmin}")

    def _scaled(self, values: Array) -> Array:
        """From 0 at vmin to 1 at vmax, limited to them; NaN for what has no place."""
        if self._norm is not None:
            return _numbers(self._norm(values)).clip(0, 1)
        low, high = self.vmin, self.vmax
        with np.errstate(all="ignore"):
            if self.is_log:
                values = np.log(np.where(values > 0, values, np.nan))
                low, high = np.log(low), np.log(high)
            values = values.clip(low, high)
            scaled: Array = (values - low) / (high - low) if high > low else np.where(np.isnan(values), values, 0.0)
        return scaled

    def __call__(self, values: Any) -> npt.NDArray[np.float64]:
        """The colors of values of any shape: an array with three numbers for each."""
        numbers = _numbers(values)
        scaled = self._scaled(numbers)
        missing = np.isnan(scaled)
        colors: npt.NDArray[np.float64] = np.array(self._map(np.where(missing, 0.0, scaled)), float)[..., :3]
        colors[missing] = self.nan_color
        return colors

    def bar(self, size: Tuple[int, int] = (256, 16)) -> Image:
        """The scale as a picture of (width, height) pixels, from vmin to vmax along its longer side, to the right or
        up, in equal steps of the color."""
        width, height = size
        places = (np.arange(max(width, height)) + 0.5) / max(width, height)
        colors = np.asarray(self._map(places), float)[:, :3]
        if width >= height:
            return Image(np.repeat(colors[np.newaxis], height, axis=0))
        return Image(np.repeat(colors[::-1, np.newaxis], width, axis=1))

    def mappable(self) -> Any:
        """For a color bar of matplotlib: figure.colorbar(scale.mappable(), ax=axes, label='B-factor')."""
        from matplotlib.cm import ScalarMappable  # type: ignore[import]
        from matplotlib.colors import LogNorm, Normalize  # type: ignore[import]

        norm = self._norm or (LogNorm if self.is_log else Normalize)(self.vmin, self.vmax)
        mappable = ScalarMappable(norm, self.colormap)
        mappable.set_array([])
        return mappable

    def __repr__(self) -> str:
        name = self.colormap if isinstance(self.colormap, str) else getattr(self.colormap, "name", "function")
        norm = ", norm='log'" if self.is_log else f", norm={type(self._norm).__name__}" if self._norm else ""
        return f"<glint.ColorScale {name} from {self.vmin:g} to {self.vmax:g}{norm}>"


def _numbers(values: Any) -> Array:
    masked: Any = np.ma  # has no types
    return np.asarray(masked.filled(masked.asarray(values).astype(float), np.nan), float)  # what is masked is missing


def colors_of(
    colors: Any,
    values: Any,
    colormap: Union[None, Colormap, ColorScale],
    vmin: Optional[float],
    vmax: Optional[float],
    norm: Norm,
    nan_color: ColorLike,
    count: Optional[int] = None,
) -> Any:
    """What the functions of many shapes are given, as colors. Without `values`, a colormap makes `colors` the values."""
    if values is None and colormap is None:
        if not (vmin is None and vmax is None and norm is None):
            raise TypeError("vmin, vmax and norm are for values=")
        if isinstance(colors, (list, tuple, np.ndarray)) and len(colors) and isinstance(colors[0], str):
            return np.array([to_color(f"colors[{i}]", color) for i, color in enumerate(colors)])
        return colors
    if values is None:
        values = colors
    elif colors is not None:
        raise TypeError("expected colors or values, found both")
    try:
        numbers = _numbers(values)
    except (TypeError, ValueError):
        raise ValueError(f"values: expected one number for each, found {shown(values)}") from None
    if numbers.ndim != 1 or (count is not None and len(numbers) != count):
        sizes = " x ".join(map(str, numbers.shape)) or "one number"
        raise ValueError(f"values: expected one number for each{'' if count is None else f', {count}'}, found {sizes}")
    if isinstance(colormap, ColorScale):
        scale = colormap
    else:
        scale = ColorScale(
            numbers, "viridis" if colormap is None else colormap, vmin=vmin, vmax=vmax, norm=norm, nan_color=nan_color
        )
    missing = int(np.isnan(scale._scaled(numbers)).sum())
    if missing:
        words = f"values: {missing} of {len(numbers)} have no color of the scale, and are drawn in nan_color"
        warn_of(words)
    return scale(numbers)
