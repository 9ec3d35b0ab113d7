# SPDX-License-Identifier: Apache-2.0
"""Another ray tracer beside a scene, value by value."""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

from . import _glint
from ._image import PathLike, to_image
from ._progress import Progress, reporting
from ._reports import Record, _Report
from ._settings import to_list
from ._tools import SceneLike, to_scene
from ._trace_log import TraceLog
from ._words import Shading


class Diagnosis(_Report):
    """What differs in a log: `conventions`, `findings`, `rows` ... (docs/diagnose.md), and `text`."""

    _diagnosed: _glint.Diagnosed

    @property
    def findings(self) -> List[Record]:
        """That which is the first difference in most pixels first: `quantity`, `sure`, `causes`, `example` ..."""
        return [Record(finding) for finding in self.data["findings"]]

    def tree(self, x: int, y: int) -> str:
        """All values of a pixel of the log, beside what they should be: the text of `--tree`.

        KeyError if it is not among `rows`; max_rows of diagnose() says how many these are.
        """
        if not any(row["pixel"] == [x, y] for row in self.data["rows"]):
            raise KeyError(f"pixel {x},{y} is not among the rows")
        return self._trees[x, y] if self._trees else self._diagnosed.tree(x, y)

    _trees: Mapping[Tuple[int, int], str] = {}

    def __getstate__(self) -> Dict[str, Any]:
        state = dict(self.__dict__)
        if state.pop("_diagnosed", None) is not None:
            pixels = {tuple(row["pixel"]) for row in self.data["rows"]}
            state["_trees"] = {(x, y): self._diagnosed.tree(x, y) for x, y in pixels}
        return state


def diagnose(
    scene: SceneLike,
    log: Union[TraceLog, PathLike],
    *,
    size: Union[None, Tuple[int, int], str] = None,
    aa: Union[None, int, str] = None,
    shading: Optional[Shading] = None,
    reflections: Optional[int] = None,
    shadows: Optional[bool] = None,
    seed: Optional[int] = None,
    convention: Optional[Mapping[str, object]] = None,
    max_rows: int = 20000,
    threads: int = 0,
    progress: Progress = None,
) -> Diagnosis:
    """Which quantity of another ray tracer's log is the first that is wrong, and which mistake gives its number.

    log: a TraceLog, or the path of a log (docs/formats/trace_log.md). size: of its picture; default: that of a TraceLog, else
    the scene's. The other keywords are those of Scene.render(); max_rows: the most values in `rows`, those of the first pixels.
    Raises GlintError with the line of a mistake of the log.
    """
    if isinstance(log, TraceLog):
        name, text = "log", log.text.encode()
        size = size or (log._width, log._height)
    elif isinstance(log, str) and "\n" in log:
        raise ValueError("log: expected a TraceLog or the path of a log, found the text of one: write it to a file")
    else:
        name, text = os.fspath(log), pathlib.Path(log).read_bytes()
    settings = dict(size=size, aa=aa, shading=shading, reflections=reflections, shadows=shadows, seed=seed)
    listed = to_list(settings) + to_list(convention or {})
    scene = to_scene(scene, size)
    with scene._rendering, reporting(progress) as report:
        found = scene._state.diagnose(name, text, listed, max_rows, threads, report)
    diagnosis = Diagnosis(json.loads(found.json()), found.text())
    diagnosis._diagnosed = found
    return diagnosis


@dataclasses.dataclass(frozen=True)
class ProposedPixel:
    """A pixel that is worth logging."""

    pixel: Tuple[int, int]
    """x, y from the top left."""
    kind: str
    """Of difference: 'edge', 'highlight', 'shadow border', 'mirror', 'material 2' ..., or 'equal'."""
    difference: float
    """Of the channel that differs most, in 255ths."""


def propose_pixels(
    scene: SceneLike,
    picture: Any,
    *,
    aa: Union[None, int, str] = None,
    shading: Optional[str] = None,
    reflections: Optional[int] = None,
    shadows: Optional[bool] = None,
    seed: Optional[int] = None,
    convention: Optional[Mapping[str, object]] = None,
    threads: int = 0,
) -> List[ProposedPixel]:
    """Up to twelve pixels of another program's picture of a scene that are worth logging, for TraceLog or GLINT_PIXELS.

    picture: an Image, a path, a PIL image or an array. The scene is rendered in its size; the keywords are those of
    Scene.render(). Empty: the pictures are equal but for rounding.
    """
    image = to_image(picture)
    settings = dict(
        size=image.size, aa=aa, shading=shading, reflections=reflections, shadows=shadows, seed=seed
    )
    listed = to_list(settings) + to_list(convention or {})
    scene = to_scene(scene)
    with scene._rendering:
        proposed = scene._state.propose_pixels(image._rendering, listed, threads)
    return [ProposedPixel((x, y), kind, difference) for x, y, kind, difference in proposed]
