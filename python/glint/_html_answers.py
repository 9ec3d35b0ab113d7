# SPDX-License-Identifier: Apache-2.0
"""Comparisons, gradings and scenes as HTML."""

from __future__ import annotations

from collections import Counter
from typing import Any, Iterable, List, Mapping, Optional, Sequence

from . import _html
from ._image import Image

_MOST_ITEMS = 12
_MOST_COUNTED = 2000


def comparison_html(
    data: Mapping[str, Any], text: str, causes: Sequence[Mapping[str, Any]], shown: Sequence[_html.Bytes]
) -> str:
    """shown: both pictures and their difference, small, or empty."""
    names = (f"{data['a']}", f"{data['b']} (reference)", "difference")
    pictures = "".join(map(_html.figure, shown, names))
    if data["identical"]:
        title = "The pictures are identical"
    else:
        title = f"The pictures differ by {data['mean']:.4g} of 255 in the mean"
        largest = data.get("largest")
        if largest:
            title += f", and by {largest['value']:.4g} at x {largest['x']}, y {largest['y']}"
    rows = []
    for name in ("all", "edges", "interiors"):
        counts = data.get(name)
        if counts and counts["pixels"]:
            part = counts["within"] / counts["pixels"]
            rows.append([name, f"{counts['pixels']:,}", _html.bar(part, 1), f"{100 * part:.2f}%"])
    heads = ("", "pixels", f"within {data['within']:.4g} of 255", "")
    found = [
        [_html.bar(cause["explained"], 1), f"{100 * cause['explained']:.0f}%", _html.escape(cause["explanation"])]
        for cause in causes
    ]
    return _html.page(
        _html.heading(_html.escape(title)),
        pictures,
        _html.table(rows, heads),
        _html.heading("Likely causes, and how much of the difference they explain") + _html.table(found) if found else "",
        _html.details("The whole text", text),
    )


def _points(points: float, most: float) -> str:
    return f"{_html.bar(points, most)}{points:.4g} of {most:.4g}"


def gradings_html(graded: Sequence[Any]) -> str:
    """A row for each submission, below the names of the parts."""
    if not graded:
        return _html.page("There are no submissions.")
    parts = graded[0].parts
    most = sum(part.most for part in parts)
    rows = []
    for one in graded:
        cells = [_html.escape(one.name)]
        if len(parts) > 1 or one.penalties:
            cells.append(f"<b>{_points(one.points, most)}</b>")
            cells[-1] += "".join(f"<div>{_html.escape(cause)}: -{points:.4g}</div>" for cause, points in one.penalties)
        elif any(other.penalties for other in graded):
            cells.append(f"<b>{_points(one.points, most)}</b>")
        for part in one.parts:
            said = part.error or part.explanation or part.cause or ""
            cells.append(f'{_points(part.points, part.most)}<div style="max-width:20em">{_html.escape(said)}</div>')
        rows.append(cells)
    has_total = len(parts) > 1 or any(one.penalties for one in graded)
    heads = ["", *(["points"] if has_total else []), *(part.name for part in parts)]
    return _html.page('<div style="overflow-x:auto">', _html.table(rows, heads), "</div>")


def _some(items: Iterable[str], count: int) -> str:
    listed = list(items)
    return ", ".join(listed) + (f" and {count - len(listed)} more" if count > len(listed) else "")


def _named(item: Any, words: str) -> str:
    return _html.escape(f"{words} '{item.name}'" if item.name else words)


def scene_html(scene: Any, image: Optional[Image], error: str = "") -> str:
    """A small picture, and what the scene has. error: why there is no picture."""
    state = scene._state
    shapes, lights, materials = state.shape_count(), state.light_count(), state.material_count()
    width, height = scene.settings["size"]
    camera = scene.camera
    # The kinds of a few shapes; a million would take seconds.
    if shapes <= _MOST_COUNTED:
        kinds = Counter(state.shape(i).kind.replace("_", " ") for i in range(shapes))
        counted = ", ".join(f"{kind}: {count:,}" for kind, count in kinds.most_common())
    else:
        counted = ""
    rows: List[List[str]] = [["shapes", f"{shapes:,}" + (f" ({_html.escape(counted)})" if counted else "")]]
    some = [state.material(i) for i in range(min(materials, _MOST_ITEMS))]
    rows.append(
        ["materials", _some((f"{_html.swatch(one.color)} {_html.escape(one.name)}".strip() for one in some), materials) or "none"]
    )
    bright = [state.light(i) for i in range(min(lights, _MOST_ITEMS))]
    rows.append(["lights", _some((f"{_html.swatch(one.color)} {_named(one, one.kind)}" for one in bright), lights) or "none"])
    if camera.frame is None:
        seen = f"at {_html.numbers(camera.position)}, looks at {_html.numbers(camera.look_at)}"
    else:
        seen = f"at {_html.numbers(camera.position)}, with a frame"
    rows.append(["camera", f"{_html.escape(camera.projection)} {seen}"])
    rows.append(["picture", f"{width} x {height}, {_html.escape(scene.settings['shading'])}"])
    if scene.files:
        rows.append(["files", _some(map(_html.escape, scene.files[:_MOST_ITEMS]), len(scene.files))])
    if image is not None:
        shown = _html.figure(image.to_uint8(), "", "the scene")
    else:
        shown = f"<div>There is no picture: {_html.escape(error)}</div>"
    return _html.page(shown, f'<div style="display:inline-block;vertical-align:top">{_html.table(rows)}</div>')
