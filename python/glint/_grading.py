# SPDX-License-Identifier: Apache-2.0
"""Points for the pictures of a class."""

from __future__ import annotations

import dataclasses
import fnmatch
import json
import os
import pathlib
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

from . import _glint
from ._errors import GlintError
from ._image import Image, PathLike, to_image
from ._progress import Progress, reporting
from ._scene import Scene
from ._tools import SceneLike, to_scene


@dataclasses.dataclass(frozen=True)
class GradedPart:
    """A part of a rubric, of one submission; without a rubric, the whole picture."""

    name: str
    points: float
    most: float
    """The part's points in the rubric; without one, 1."""
    error: str
    """Why there are no points: 'no file *phong*.png'; else empty."""
    cause: Optional[str]
    """The id of the likeliest cause of what is wrong."""
    explanation: str
    """What that cause is, and how to correct it."""


@dataclasses.dataclass(frozen=True)
class Graded:
    """A submission."""

    name: str
    parts: Tuple[GradedPart, ...]

    @property
    def points(self) -> float:
        return sum(part.points for part in self.parts)


Submissions = Union[PathLike, Mapping[str, Any]]
_ENDINGS = (".png", ".ppm", ".exr", ".jpg", ".jpeg")


def _files(folder: PathLike) -> Dict[str, pathlib.Path]:
    return {path.name: path for path in sorted(pathlib.Path(folder).iterdir())}


def grade(
    submissions: Submissions,
    scene: Optional[SceneLike] = None,
    *,
    reference: Any = None,
    rubric: Optional[PathLike] = None,
    progress: Progress = None,
) -> List[Graded]:
    """Points for pictures, and what is wrong with each.

    Without a rubric: submissions is a folder of pictures, or a mapping of names to pictures; each is compared
    with the reference, which is the scene's own picture unless given, and gets the fraction of equal
    pixels (within 2/255) as its points. With a rubric (docs/teaching.md): a folder of folders, or a mapping of
    names to folders or to mappings of file names to pictures. Each part is judged alone: its points are the
    command's `points_alone`.
    """
    own = None if scene is None else to_scene(scene)
    if rubric is not None:
        if own is None:
            raise TypeError("a rubric needs the scene, which renders its parts")
        return _grade_by_rubric(submissions, own, rubric, progress)
    if reference is None:
        if own is None:
            raise TypeError("grade() needs a scene or a reference")
        reference = own.render()
    wanted = to_image(reference)
    if not isinstance(submissions, Mapping):
        submissions = {n: p for n, p in _files(submissions).items() if p.suffix.lower() in _ENDINGS}
    rows = []
    for name, picture in submissions.items():
        image, error = _open(picture, wanted)
        points = 0.0
        if image is not None:
            counts = json.loads(_compare_plainly(image, wanted))["all"]
            points = counts["within"] / counts["pixels"]
        rows.append((name, image, points, error))
    wrong = [image for _, image, points, _ in rows if image is not None and points < 1]
    with reporting(progress) as report:
        found = iter(
            _glint.find_causes(
                [i._rendering for i in wrong], wanted._rendering, None if own is None else own._state, report
            )
            if wrong
            else []
        )
    graded = []
    for name, image, points, error in rows:
        cause = next(found) if image is not None and points < 1 else None
        part = GradedPart("picture", points, 1.0, error, *(cause[:2] if cause else (None, "")))
        graded.append(Graded(name, (part,)))
    return graded


def _compare_plainly(a: Image, b: Image) -> str:
    return _glint.compare(a._rendering, b._rendering, "a", "b", None, False, False, 2.0, None)[0]


def _open(picture: Any, wanted: Image) -> Tuple[Optional[Image], str]:
    try:
        image = to_image(picture)
    except (GlintError, OSError, ValueError) as error:
        return None, str(error)
    if image.size != wanted.size:
        return None, f"{image.width}x{image.height} pixels, expected {wanted.width}x{wanted.height}"
    return image, ""


def _find(files: Mapping[str, Any], pattern: str) -> Tuple[Any, str]:
    matches = [name for name in files if fnmatch.fnmatchcase(name, pattern)]
    if len(matches) == 1:
        return files[matches[0]], ""
    return None, f"no file {pattern}" if not matches else f"several files {pattern}: {', '.join(matches)}"


def _grade_by_rubric(
    submissions: Submissions, scene: Scene, rubric: PathLike, progress: Progress
) -> List[Graded]:
    if not isinstance(submissions, Mapping):
        submissions = {n: p for n, p in _files(submissions).items() if p.is_dir()}
    folders = {n: f if isinstance(f, Mapping) else _files(f) for n, f in submissions.items()}
    graded: Dict[str, List[GradedPart]] = {name: [] for name in folders}
    with reporting(progress) as report:
        for part in _glint.rubric_parts(
            scene._state, os.fspath(rubric), pathlib.Path(rubric).read_bytes(), report
        ):
            wanted = Image._of(part.wanted())
            images: Dict[str, Image] = {}
            scores: Dict[str, Tuple[float, str]] = {}
            for name, files in folders.items():
                picture, error = _find(files, part.file)
                image = None
                if not error:
                    image, error = _open(picture, wanted)
                points = part.grade(image._rendering)[0] if image is not None else 0.0
                scores[name] = points, error
                if image is not None and points < part.points:
                    images[name] = image
            causes = part.causes([i._rendering for i in images.values()], report) if images else []
            found = dict(zip(images, causes))
            for name, (points, error) in scores.items():
                cause = found.get(name)
                graded[name].append(
                    GradedPart(part.name, points, part.points, error, *(cause[:2] if cause else (None, "")))
                )
    return [Graded(name, tuple(parts)) for name, parts in graded.items()]
