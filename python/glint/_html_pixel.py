# SPDX-License-Identifier: Apache-2.0
"""An explanation as HTML: the picture with the pixel marked, and the terms as bars."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _html
from ._errors import GlintError
from ._image import Image

_REASONS = {
    "adds": "adds",
    "blocked": "blocked",
    "behind": "behind the surface",
    "no_color": "black on this surface",
    "faded": "too far: its attenuation is 0",
    "in_surface": "in the surface",
    "outside_cone": "P is outside its cone",
    "faint": "too faint",
    "back_of_light": "it faces away",
}

_MOST_LIGHTS = 16


@dataclasses.dataclass
class PixelView:
    """The scene of an explanation, which draws the pixel's surroundings when they are asked for."""

    scene: Any
    pixel: Tuple[int, int]
    settings: Mapping[str, Any]

    def _size(self) -> Tuple[int, int]:
        size = self.settings.get("size") or self.scene.settings["size"]
        width, height = size.split("x") if isinstance(size, str) else size
        return int(width), int(height)

    def draw(self, value: Sequence[float]) -> str:
        """Two pictures as HTML, or why there are none: the scene may have been changed since it was explained."""
        (x, y), (width, height) = self.pixel, self._size()
        part_width, part_height = min(width, 33), min(height, 25)
        left = min(max(x - part_width // 2, 0), width - part_width)
        top = min(max(y - part_height // 2, 0), height - part_height)
        factor = min(1.0, 264 / max(width, height))
        small = max(1, round(factor * width)), max(1, round(factor * height))
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # issued where the pixel was explained
                whole = self.scene.render(**{**self.settings, "size": small, "aa": 1})
                part: Image = self.scene.render(**self.settings, crop=(part_width, part_height, left, top))
        except (GlintError, MemoryError, ValueError) as error:
            return f"<div>There is no picture: {_html.escape(error)}</div>"
        if not np.array_equal(part.array[y - top, x - left], np.asarray(value, np.float32), equal_nan=True):
            return "<div>There is no picture: the scene has been changed since this pixel was explained.</div>"
        times = max(1, 264 // max(small))
        overview = _html.enlarged(whole.to_uint8(), times)
        at_x, at_y = (int((p + 0.5) * n / m * times) for p, n, m in ((x, small[0], width), (y, small[1], height)))
        _html.mark(overview, (at_x - 4, at_y - 4, at_x + 5, at_y + 5))
        scale = max(1, 264 // max(part_width, part_height))
        close = _html.enlarged(part.to_uint8(), scale)
        corner = scale * (x - left), scale * (y - top)
        _html.mark(close, (*corner, corner[0] + scale, corner[1] + scale))
        columns, lines = f"{left} to {left + part_width - 1}", f"{top} to {top + part_height - 1}"
        return _html.figure(overview, f"pixel {x},{y} of {width}x{height}") + _html.figure(
            close, f"x {columns}, y {lines}", f"the pixels around {x},{y}, enlarged"
        )


def _item(item: Mapping[str, Any], noun: str = "") -> str:
    """sphere 'ball', or by its number, counted from 1."""
    words, name = item.get("kind") or noun, item.get("name")
    number = f" {item['index'] + 1}" if "index" in item else ""
    return _html.escape(f"{words} '{name}'" if name else words + number)


def _added(terms: Sequence[Mapping[str, Any]]) -> List[float]:
    return [sum(one["diffuse"][i] + one["specular"][i] for one in terms) for i in range(3)]


def _lights_of(hit: Mapping[str, Any]) -> List[List[Mapping[str, Any]]]:
    """The terms by light: samples of an area light follow each other."""
    lights: List[List[Mapping[str, Any]]] = []
    for terms in hit.get("lights", ()):
        if lights and "weight" in terms and lights[-1][0]["light"].get("index") == terms["light"].get("index"):
            lights[-1].append(terms)
        else:
            lights.append([terms])
    return lights


def _light_row(terms: Sequence[Mapping[str, Any]], most: float) -> List[str]:
    adding = [one for one in terms if one["reason"] == "adds"]
    first = max(terms, key=lambda one: float(sum(one["diffuse"]) + sum(one["specular"])))
    blocker = (first.get("blocker") or {}).get("shape")
    if len(terms) > 1:
        reason = f"{len(adding)} of {len(terms)} samples add"
    elif first["reason"] == "blocked" and blocker:
        reason = f"blocked by {_item(blocker)}"
    else:
        reason = _html.escape(_REASONS.get(first["reason"], str(first["reason"]).replace("_", " ")))
    color = _added(terms)
    light = first["light"]
    row = [_item({**light, "kind": f"{light['kind']} light"}), reason, _html.number(first["n_l"])]
    if not any(color):
        return [*row, "", ""]
    parts = (_html.numbers(sum(one[part][i] for one in terms) for i in range(3)) for part in ("diffuse", "specular"))
    return [*row, _html.color_bars(color, most), "diffuse {} + specular {}".format(*parts)]


def _surface(data: Mapping[str, Any], sample: Optional[int]) -> str:
    """Of the camera ray that the text is about: what it hits, and the terms there."""
    n = data["samples"]
    wanted = [n // 2, n // 2] if sample is None else [sample % n, sample // n]
    ray = next((ray for ray in data["rays"] if ray["kind"] == "camera" and ray["sample"] == wanted), None)
    if ray is None:
        return ""
    which = f" of sample {ray['sample'][0]},{ray['sample'][1]}" if data["samples"] > 1 else ""
    hit: Optional[Dict[str, Any]] = ray.get("hit")
    if not hit:
        return _html.heading(f"The camera ray{which} hits nothing")
    terms = [(name, hit[name]) for name in ("ambient", "diffuse", "specular", "emission") if name in hit]
    lights = _lights_of(hit)
    most = _html.largest([*(value for _, value in terms), *map(_added, lights)])
    rows = [
        [_html.escape(name), "", "", _html.color_bars(value, most), _html.numbers(value)]
        for name, value in terms
        if name in ("ambient", "emission") and any(value)
    ]
    shown = sorted(sorted(range(len(lights)), key=lambda i: -max(_added(lights[i])))[:_MOST_LIGHTS])
    rows += [_light_row(lights[i], most) for i in shown]
    if len(lights) > len(shown):
        rows.append([f"{len(lights) - len(shown)} more lights", "that add less", "", "", ""])
    material = hit.get("material")
    made_of = f", {_item(material, 'material')} {_html.swatch(material['color'])}" if material else ""
    place = f"P {_html.numbers(hit['point'])}, N {_html.numbers(hit['normal'])}"
    if material:
        k = ", ".join(f"k_{name[0]} {_html.numbers(material[name])}" for name in ("ambient", "diffuse", "specular"))
        place += f"; {k}, n {_html.number(material['shininess'])}"
    parts = _html.heading(f"The camera ray{which} hits {_item(hit['shape'])}{made_of}") + f"<div>{place}</div>"
    return parts + (_html.table(rows, ("", "", "N·L", "r, g, b", "")) if rows else "")


def explanation_html(data: Mapping[str, Any], text: str, sample: Optional[int], pictures: str) -> str:
    """The whole output. sample: which of the pixel's the text is about; pictures: of PixelView.draw(), or empty."""
    if "value" not in data:
        return _html.page(f"<pre>{_html.escape(text)}</pre>")
    value = data["value"]
    layers = [(name, color) for name, color in data["layers"].items() if any(color)]
    most = _html.largest([*(color for _, color in layers), value])
    rows = [[_html.escape(name), _html.color_bars(color, most), _html.numbers(color)] for name, color in layers]
    rows.append(["<b>value</b>", _html.color_bars(value, most), f"<b>{_html.numbers(value)}</b>"])
    x, y = data["pixel"]
    bytes_of = data.get("bytes")
    shown = [byte / 255 for byte in bytes_of] if bytes_of else value
    said = f" bytes {' '.join(map(str, bytes_of))}" if bytes_of else ""
    samples = f", the mean of {data['samples']} x {data['samples']} samples" if data["samples"] > 1 else ""
    others = sum(ray["kind"] != "camera" for ray in data["rays"])
    more = f" ({others} more ray{'' if others == 1 else 's'})" if others else ""
    return _html.page(
        _html.heading(f"Pixel {x},{y} {_html.swatch(shown)}{_html.escape(said)}{samples}"),
        pictures,
        _html.table(rows, ("layer", "r, g, b", "")),
        _surface(data, sample),
        _html.details(f"The whole text{more}", text),
    )
