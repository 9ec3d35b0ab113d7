# SPDX-License-Identifier: Apache-2.0
"""Points for the pictures of a class."""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

from . import _glint
from ._errors import GlintError
from ._html_answers import gradings_html
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
    points_alone: float
    """The points if mistakes that cost another part were counted here, too."""
    followed: Tuple[str, ...] = ()
    """The causes, counted in other parts, with which the picture was judged, because that gives more points."""


@dataclasses.dataclass(frozen=True)
class Graded:
    """A submission."""

    name: str
    parts: Tuple[GradedPart, ...]
    penalties: Tuple[Tuple[str, float], ...] = ()
    """The cause and the points of each penalty of the rubric."""

    @property
    def points(self) -> float:
        """Of all parts, less the penalties; at least 0."""
        points = sum(part.points for part in self.parts)
        return max(0.0, points - sum(points for _, points in self.penalties))

    def _repr_html_(self) -> str:
        return gradings_html([self])


class Grades(List[Graded]):
    """What grade() returns: a list, which a notebook shows as a table."""

    def _repr_html_(self) -> str:
        return gradings_html(self)


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
) -> Grades:
    """Points for pictures, and what is wrong with each.

    Without a rubric: submissions is a folder of pictures, or a mapping of names to pictures; each is compared
    with the reference, which is the scene's own picture unless given, and gets the fraction of equal
    pixels (within 2/255) as its points. With a rubric (docs/teaching.md): a folder of folders, or a mapping of
    names to folders or to mappings of file names to pictures. Files, points and causes are those of `glint grade`.
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
        image, error = _open(picture)
        if image is not None and image.size != wanted.size:
            error = f"{image.width}x{image.height} pixels, expected {wanted.width}x{wanted.height}"
            image = None
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
    graded = Grades()
    for name, image, points, error in rows:
        cause = next(found) if image is not None and points < 1 else None
        name_of_cause, explanation = cause[:2] if cause else (None, "")
        part = GradedPart("picture", points, 1.0, error, name_of_cause, explanation, points)
        graded.append(Graded(name, (part,)))
    return graded


def _compare_plainly(a: Image, b: Image) -> str:
    return _glint.compare(a._rendering, b._rendering, "a", "b", None, False, False, 2.0, 0, None)[0]


def _open(picture: Any) -> Tuple[Optional[Image], str]:
    try:
        return to_image(picture), ""
    except (GlintError, OSError, ValueError) as error:
        return None, str(error)


def _grade_by_rubric(
    submissions: Submissions, scene: Scene, rubric: PathLike, progress: Progress
) -> Grades:
    folders: List[Tuple[str, Any, str]]
    if isinstance(submissions, Mapping):
        folders = [(name, files, "") for name, files in submissions.items()]
    else:
        folders = [(name, path, error) for name, path, error in _glint.submission_folders(os.fspath(submissions))]
    names = [name for name, _, _ in folders]

    def find(submission: int, pattern: str) -> Tuple[str, str, Optional[_glint.Rendering]]:
        _, files, error = folders[submission]
        if error:
            return "", error, None
        if not isinstance(files, Mapping):
            try:
                files = {name: path for name, path in _files(files).items() if not path.is_dir()}
            except OSError as unreadable:
                return "", f"the folder cannot be read: {unreadable.strerror}", None
        for name in sorted(files):
            if _glint.is_match(name, pattern):
                image, error = _open(files[name])
                return name, error, None if image is None else image._rendering
        return "", f"no file {pattern}", None

    with reporting(progress) as report:
        rows, graded = _glint.grade_by_rubric(
            scene._state, os.fspath(rubric), pathlib.Path(rubric).read_bytes(), names, find, report
        )
    return Grades(
        Graded(
            name,
            tuple(
                GradedPart(part, points, most, error, cause, explanation, alone, followed)
                for (part, most), (points, error, cause, explanation, alone, followed) in zip(rows, parts)
            ),
            penalties,
        )
        for name, (parts, penalties) in zip(names, graded)
    )
