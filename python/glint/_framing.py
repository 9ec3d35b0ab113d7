# SPDX-License-Identifier: Apache-2.0
"""Cameras that see a whole scene, and that go around it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Iterator, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _glint
from ._expect import expect, shown, suggest
from ._glint import Camera
from ._values import Vec3, VectorLike

if TYPE_CHECKING:
    from ._image import Image
    from ._scene import Scene

Direction = Union[str, VectorLike]
Bounds = Tuple[VectorLike, VectorLike]
_Array = npt.NDArray[np.float64]

DIRECTIONS: Dict[str, Tuple[float, float, float]] = {
    "iso": (1, 1, 1),
    "front": (0, 0, 1),
    "back": (0, 0, -1),
    "right": (1, 0, 0),
    "left": (-1, 0, 0),
    "top": (0, 1, 0),
    "bottom": (0, -1, 0),
    "+x": (1, 0, 0),
    "-x": (-1, 0, 0),
    "+y": (0, 1, 0),
    "-y": (0, -1, 0),
    "+z": (0, 0, 1),
    "-z": (0, 0, -1),
}
"""From the subject to the eye, by name."""


def _vector(name: str, value: Any) -> _Array:
    vector = np.asarray(value)
    if vector.dtype.kind not in "uif" or vector.shape != (3,) or not np.isfinite(vector).all() or not vector.any():
        raise ValueError(f"{name}: expected three numbers, not all 0, found {shown(value)}")
    return np.asarray(vector / np.linalg.norm(vector.astype(float)), float)


def to_direction(direction: Direction) -> _Array:
    """The unit vector from the subject to the eye."""
    if not isinstance(direction, str):
        return _vector("direction", direction)
    if direction not in DIRECTIONS:
        raise ValueError(
            f"direction: expected one of {', '.join(DIRECTIONS)} or three numbers, found {direction!r}"
            f"{suggest(direction, DIRECTIONS)}"
        )
    return _vector("direction", DIRECTIONS[direction])


def _upright(up: Any, direction: _Array) -> _Array:
    """up, or another axis if the view is along it."""
    wanted = _vector("up", up)
    if np.linalg.norm(np.cross(wanted, direction)) > 1e-6:
        return wanted
    return np.array([0.0, 0.0, -1.0]) if abs(direction[1]) > 0.9 else np.array([0.0, 1.0, 0.0])


def _corners(subject: Any) -> Tuple[_Array, _Array]:
    """The corners of the bounds of a scene or of (min, max), relative to their center, and the center."""
    bounds = getattr(subject, "bounds", subject)
    if bounds is None:
        raise ValueError("the scene has nothing to fit: it has no shapes, or all are planes without bounds")
    try:
        ends = np.asarray(bounds, float)
    except (TypeError, ValueError):
        ends = np.zeros(0)
    if ends.shape != (2, 3) or not (np.isfinite(ends).all() and (ends[0] <= ends[1]).all()):
        raise ValueError(f"expected a scene or its bounds (min, max), two points, found {shown(bounds)}")
    center = (ends[0] + ends[1]) / 2
    choices = np.array(np.meshgrid([0, 1], [0, 1], [0, 1])).T.reshape(-1, 3)
    return np.where(choices == 0, ends[0], ends[1]) - center, center


def fit(
    self: Camera,
    scene: Union[Scene, Bounds],
    direction: Direction = "iso",
    margin: float = 0.05,
    *,
    up: Optional[VectorLike] = None,
    size: Optional[Tuple[int, int]] = None,
) -> Camera:
    """Moves the camera so that it sees the whole scene, and returns it.

    scene: a Scene, or bounds (min, max) in world space, such as a part's; direction: from the scene to the eye, three
    numbers or 'iso' (1, 1, 1), 'front' (+z), 'back', 'right' (+x), 'left', 'top' (+y), 'bottom', or an axis such as
    '-x'; margin: the part of the picture that stays free on each side, from 0 to less than 0.5; up: what is upright, by
    default the camera's, or -z (or y) if that is the direction; size: of the picture in pixels, by default the
    scene's, or 640 x 480 for bounds. The camera's projection and its fov stay; a frame is removed. Planes have no
    bounds and do not count. ValueError if there is nothing to see.
    """
    expect("margin", margin, float)
    if not 0 <= margin < 0.5:
        raise ValueError(f"margin: expected a number from 0 to less than 0.5, found {margin!r}")
    to_eye = to_direction(direction)
    corners, center = _corners(scene)
    upright = _upright(self.up if up is None else up, to_eye)
    right = np.cross(upright, to_eye)
    right /= np.linalg.norm(right)
    x, y, z = (corners @ axis for axis in (right, np.cross(to_eye, right), to_eye))
    settings = getattr(scene, "settings", None)
    width, height = size if size is not None else settings["size"] if settings is not None else (640, 480)
    free = 1 - 2 * margin
    radius = float(np.linalg.norm(corners, axis=1).max()) or 1.0
    if self.projection == "orthographic":
        self.width = 2 * max(float(np.abs(x).max()), float(np.abs(y).max()) * width / height, 1e-9 * radius) / free
        distance = 2 * radius
    else:
        along = np.tan(np.radians(self.fov) / 2) * free
        across = along * (height / width if self.fov_axis == "x" else width / height)
        tan_x, tan_y = (along, across) if self.fov_axis == "x" else (across, along)
        distance = float(np.max(z + np.maximum(np.abs(x) / tan_x, np.abs(y) / tan_y)))
        distance = max(distance, float(z.max()) + 1e-3 * radius)
    self.frame = None
    self.position = center + distance * to_eye
    self.look_at = center
    self.up = upright
    return self


def orbit(self: Camera, right: float = 0.0, up: float = 0.0) -> Camera:
    """Moves the camera around the point that it looks at, and returns it.

    right: degrees to the right around the camera's `up`; up: degrees towards it, which stops 0.1 degrees before it.
    The distance stays.
    """
    expect("right", right, float)
    expect("up", up, float)
    target = np.asarray(self.look_at, float)
    arm = np.asarray(self.position, float) - target
    length = float(np.linalg.norm(arm))
    if self.frame is not None or not length:
        raise ValueError("the camera looks at no point: it has a frame, or its position is look_at")
    axis = _vector("up", self.up)
    height = np.arcsin(np.clip(arm @ axis / length, -1, 1))
    level = arm - (arm @ axis) * axis
    if not np.linalg.norm(level) > 1e-9 * length:
        level = np.cross(axis, [0.0, 0.0, 1.0] if abs(axis[2]) < 0.9 else [1.0, 0.0, 0.0])
    level /= np.linalg.norm(level)
    turn = np.radians(right)
    level = np.cos(turn) * level + np.sin(turn) * np.cross(axis, level)
    limit = np.radians(89.9)
    height = np.clip(height + np.radians(up), -max(limit, abs(height)), max(limit, abs(height)))
    self.position = target + length * (np.cos(height) * level + np.sin(height) * axis)
    return self


def zoom(self: Camera, factor: float) -> Camera:
    """Enlarges what is in the middle of the picture, and returns the camera: it stays where it is, and its fov or width changes.

    factor: > 0; 2: twice as large.
    """
    expect("factor", factor, float)
    if not 0 < factor < 1e12:
        raise ValueError(f"factor: expected a number > 0, found {factor!r}")
    if self.projection == "orthographic":
        self.width /= factor
    else:
        self.fov = float(np.degrees(2 * np.arctan(np.tan(np.radians(self.fov) / 2) / factor)))
    return self


class CountedImages:
    """Images that are made one after the other, and how many they are: for progress."""

    def __init__(self, images: Iterator[Image], count: int) -> None:
        self._images = images
        self._left = max(0, count)

    def __iter__(self) -> CountedImages:
        return self

    def __next__(self) -> Image:
        image = next(self._images)
        self._left -= 1
        return image

    def __length_hint__(self) -> int:
        return self._left


def frame_unset(scene: Scene, size: Any = None) -> None:
    """Fits the camera of a scene that was made in Python, if nothing but this has ever set it."""
    if scene._framed is None:
        return
    if scene.camera != scene._framed:
        scene._framed = None
        return
    if scene._state.shape_count() == 0:
        return
    bounds: Optional[Tuple[Vec3, Vec3]] = scene.bounds
    if bounds is None:
        return
    if isinstance(size, str):
        width, _, height = size.partition("x")
        size = (int(width), int(height)) if width.isdigit() and height.isdigit() else None
    is_size = isinstance(size, (tuple, list)) and len(size) == 2 and min(size) > 0
    fit(scene.camera, bounds, size=size if is_size else scene.settings["size"])
    scene._framed = scene.camera.__copy__()


def add_methods() -> None:
    """Once, when the package is imported."""
    for name, method in (("fit", fit), ("orbit", orbit), ("zoom", zoom)):
        method.__qualname__ = f"Camera.{name}"
        setattr(_glint.Camera, name, method)
