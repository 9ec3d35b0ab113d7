# SPDX-License-Identifier: Apache-2.0
"""Blender's camera, by Camera.view_frame: sensor fit, pixel aspect, shift and scale are already in it."""
import math
import struct
from dataclasses import dataclass

from . import ignored
from .text import block, number, vector
from .vectors import cross, dot, sub


class CameraError(Exception):
    """There is no camera that glint could take; the text says why."""


@dataclass
class View:
    """What a camera sees, in world space."""

    name: str
    position: tuple
    right: tuple  # the camera's axes, of unit length; a parent's scale may leave them no right angles
    up: tuple
    forward: tuple
    is_perspective: bool
    left: float  # the edges of the frame: at depth 1 if perspective, else in world units
    right_edge: float
    bottom: float
    top: float
    size: tuple  # the whole picture, in pixels
    clip: tuple = (0.0, math.inf)  # Blender shows nothing nearer and nothing farther

    def _coordinates(self, point):
        """(x, y, depth) along the axes: Cramer's rule, since they need not be at right angles."""
        away, axes = sub(point, self.position), (self.right, self.up, self.forward)
        crosses = (cross(axes[1], axes[2]), cross(axes[2], axes[0]), cross(axes[0], axes[1]))
        volume = dot(axes[0], crosses[0])
        return tuple(dot(away, c) / volume for c in crosses) if volume else (0.0, 0.0, 0.0)

    def depth(self, point):
        return self._coordinates(point)[2]

    def clips(self, point):
        """Whether a point is in the picture, but cut off by Blender's clipping. The point's coordinates may be arrays of numpy."""
        near, far = self.clip
        x, y, depth = self._coordinates(point)
        scale = depth if self.is_perspective else 1.0
        return ((depth > 0) & ((depth < near) | (depth > far)) & (self.left * scale <= x) & (x <= self.right_edge * scale)
                & (self.bottom * scale <= y) & (y <= self.top * scale))

    def ray_lengths(self, crop=None):
        """For each pixel, rows from the top: the length of its ray from the eye to the depth 1; glint's depths are lengths.
        crop: as border() gives it."""
        (width, height), (columns, rows, first_x, first_y) = self.size, crop or (*self.size, 0, 0)
        if not self.is_perspective:
            return [1.0] * (columns * rows)
        xs = [self.left + (self.right_edge - self.left) * (i + 0.5) / width for i in range(first_x, first_x + columns)]
        squared = [1 + dot(self.right, self.right) * x * x + 2 * x * dot(self.right, self.forward) for x in xs]
        lengths = []
        for j in range(first_y, first_y + rows):
            y = self.top - (self.top - self.bottom) * (j + 0.5) / height
            along = y * y + 2 * y * dot(self.up, self.forward)
            across = 2 * y * dot(self.right, self.up)
            lengths += [math.sqrt(s + along + across * x) for s, x in zip(squared, xs)]
        return lengths

    @property
    def fov_x(self):
        """Degrees across the width of the frame, as if it were not shifted."""
        return math.degrees(2 * math.atan((self.right_edge - self.left) / 2))

    @property
    def is_rigid(self):
        """Whether look_at and up say all of the axes: they are at right angles, and no mirror image."""
        return all(abs(a - b) < 1e-6 for a, b in zip(self.right, cross(self.forward, self.up)))

    @property
    def is_centred(self):
        """Whether the frame is around the view direction, and its pixels are square."""
        width, height = self.right_edge - self.left, self.top - self.bottom
        w, h = self.size
        return (abs(self.left + self.right_edge) < 1e-6 * width and abs(self.bottom + self.top) < 1e-6 * height
                and abs(width / w * h / height - 1) < 1e-6)


def picture_size(render):
    """The whole picture in pixels, as Blender rounds it."""
    return (max(1, render.resolution_x * render.resolution_percentage // 100),
            max(1, render.resolution_y * render.resolution_percentage // 100))


def _single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def border(render):
    """(width, height, x, y) of a border render, from the top left, as Blender rounds it; None for the whole picture."""
    if not render.use_border:
        return None
    w, h = picture_size(render)
    x0, x1 = (int(_single(v * w)) for v in (render.border_min_x, render.border_max_x))
    y0, y1 = (int(_single(v * h)) for v in (render.border_min_y, render.border_max_y))
    if (x0, y0, x1, y1) == (0, 0, w, h) or x1 <= x0 or y1 <= y0:
        return None
    return x1 - x0, y1 - y0, x0, h - y1


def read(camera, scene, report):
    """The View of a camera object. Raises CameraError if there is none, or its projection is not glint's."""
    if camera is None:
        raise CameraError("the scene has no camera: add one (Add > Camera), or make one active (Ctrl+Numpad 0)")
    item = f"camera '{camera.name}'"
    if camera.type != "CAMERA":
        raise CameraError(f"the scene's camera '{camera.name}' is not a camera but of type {camera.type}")
    data = camera.data
    if data.type not in ("PERSP", "ORTHO"):
        raise CameraError(f"{item} is of type {data.type}: glint has perspective and orthographic cameras")
    ignored.report(data, item, report)
    matrix = camera.matrix_world.normalized()
    axes = matrix.to_3x3()
    top_right, bottom_right, _, top_left = (tuple(v) for v in data.view_frame(scene=scene))
    perspective = data.type == "PERSP"
    depth = -top_right[2] if perspective else 1.0
    width, height = top_right[0] - top_left[0], top_right[1] - bottom_right[1]
    if not all(math.isfinite(v) for v in (*(x for row in matrix for x in row), width, height, depth)):
        raise CameraError(f"{item} has numbers that are not finite")
    if not all(axis.length > 0 for axis in axes.col) or not width > 0 or not height > 0 or not depth > 0:
        raise CameraError(f"{item} has no extent: check its scale and its width")
    return View(camera.name, tuple(matrix.translation), tuple(axes.col[0]), tuple(axes.col[1]),
                tuple(-v for v in axes.col[2]), perspective, top_left[0] / depth, top_right[0] / depth,
                bottom_right[1] / depth, top_right[1] / depth, picture_size(scene.render),
                (data.clip_start, data.clip_end))


def of_viewport(view_matrix, window_matrix, size):
    """The View of a 3D viewport: the axes by region_data.view_matrix, the frame by region_data.window_matrix, which is a
    projection to -1 ... 1 (OpenGL's). size: the region's, in pixels. Nothing is clipped."""
    axes, matrix = view_matrix.inverted().normalized(), window_matrix
    perspective = matrix[3][3] == 0
    edges = [[(side + matrix[i][2]) / matrix[i][i] if perspective else (side - matrix[i][3]) / matrix[i][i]
              for side in (-1, 1)] for i in range(2)]
    forward = tuple(-v for v in axes.col[2][:3])
    # Blender shows what is behind an orthographic viewpoint, too: from the near plane on.
    near = 0.0 if perspective else (matrix[2][3] + 1) / matrix[2][2]
    position = _sum((1, tuple(axes.translation)), (near, forward))
    return View("viewport", position, tuple(axes.col[0][:3]), tuple(axes.col[1][:3]), forward, perspective,
                *edges[0], *edges[1], size, (-math.inf, math.inf))


def _sum(*terms):
    return tuple(sum(factor * v[i] for factor, v in terms) for i in range(3))


def camera_block(view):
    """camera { }: look_at and an angle or a width where they say it all, else the frame."""
    width, height = view.right_edge - view.left, view.top - view.bottom
    x, y = (view.left + view.right_edge) / 2, (view.bottom + view.top) / 2
    position, entries = view.position, []
    if not view.is_perspective:
        entries.append(("projection", "orthographic"))
        position = _sum((1, position), (x, view.right), (y, view.up))
    entries.append(("position", vector(position)))
    square = abs(width / view.size[0] * view.size[1] / height - 1) < 1e-6
    if view.is_rigid and (view.is_centred or (square and not view.is_perspective)):
        entries += [("look_at", vector(_sum((1, position), (10, view.forward)))), ("up", vector(view.up)),
                    ("fov_x", number(view.fov_x)) if view.is_perspective else ("width", number(width))]
    else:
        shift = ((x, view.right), (y, view.up)) if view.is_perspective else ()
        entries += [("right", vector(_sum((width, view.right)))), ("up", vector(_sum((height, view.up)))),
                    ("forward", vector(_sum((1, view.forward), *shift)))]
    return block("camera", None, entries)
