# SPDX-License-Identifier: Apache-2.0
"""Renders the pictures of a viewport step by step: coarse at first, then at full size, then with all samples. Each step is short, so
that Blender can ask for it in its main thread: threads of Python do not go well with Blender. Imports no bpy."""
import math
import re
import time
from dataclasses import dataclass, field

STEP_SECONDS = 0.03  # for the first picture of a view, and for each step: 15 a second with what Blender itself needs
COARSEST = 8  # pixels of the viewport a side for one of the picture
LONGEST_SECONDS = 0.1  # a step that takes longer is given up, and done again in smaller parts


@dataclass(frozen=True, eq=False)
class SceneParts:
    """A scene's text: all but the shapes, and the shapes. shapes is None if the format has no such parts."""

    head: str
    shapes: str
    format: str
    name: str  # of the file that it would be in; mesh files are beside it
    settings: dict = field(default_factory=dict)  # by the names of options of `glint render`, in place of the text's


@dataclass(frozen=True)
class ViewRequest:
    """A view of a scene. Equal ones have the same SceneParts, not only equal ones."""

    written: SceneParts
    camera: str  # camera { } of a .glint text
    size: tuple  # pixels
    aa: str  # samples, as of `glint render --aa`
    alpha: bool


class World:
    """The viewport's scene in glint. A scene with the same shapes takes over the rest, and builds no new hierarchy."""

    def __init__(self, glint):
        self._glint, self._scene, self._written = glint, None, None
        self.loads = 0  # how often shapes were read

    def show(self, written):
        """Raises glint.GlintError."""
        old, self._written = self._written, None  # none if this fails
        if written is not old and not (old and self._take_over(written, old)):
            self._scene = self._glint.loads(written.head + (written.shapes or ""), written.format, name=written.name)
            self._scene.settings.update(written.settings)
            self.loads += 1
        self._written = written

    def _take_over(self, written, old):
        if written.shapes is None or written.shapes != old.shapes or _textures_of(written.head) != _textures_of(old.head):
            return False
        new, scene = self._glint.loads(_without_files(written.head), written.format, name=written.name), self._scene
        if [m.name for m in new.materials] != [m.name for m in scene.materials]:
            return False
        for i, made in enumerate(new.materials):
            here = scene.materials[i]
            if made.texture is not None:
                if here.texture is None or here.texture.name != made.texture.name:
                    return False
                made.texture = here.texture
            if made != here:
                scene.materials[i] = made
        scene.lights = list(new.lights)
        for name in ("background", "fog", "occlusion"):
            setattr(scene, name, getattr(new, name))
        for here, there in ((scene.settings, new.settings), (scene.conventions, new.conventions)):
            for key, value in there.items():
                if here[key] != value:
                    here[key] = value
        return True

    def render(self, wanted, scale, aa, rows=None, progress=None):
        """Rows (from the top, first and last + 1; None: all) of the picture with 1/scale of the pixels a side: float32 (height, width,
        4), premultiplied, rows from the bottom."""
        import numpy as np  # glint's package has it  pylint: disable=import-outside-toplevel
        scene = self._scene
        scene.camera = self._glint.loads(wanted.camera).camera
        size = tuple(max(1, side // scale) for side in wanted.size)
        crop = (size[0], rows[1] - rows[0], 0, rows[0]) if rows else None
        image = scene.render(size=size, aa=aa, alpha=wanted.alpha, crop=crop, progress=progress)
        rgba = np.ones((*image.array.shape[:2], 4), np.float32)
        rgba[..., :3] = image.array[::-1]
        if wanted.alpha:
            rgba[..., 3] = image.layers["alpha"][::-1].reshape(rgba.shape[:2])
        return rgba


_TEXTURE = re.compile(r"^texture .*$", re.MULTILINE)
_FILE = re.compile(r'\bfile = "(?:[^"\\]|\\.)*"')


def _textures_of(head):
    """The blocks of a head's textures. Other texels have another file."""
    return _TEXTURE.findall(head)


def _without_files(head):
    """A head whose textures are one texel each: no picture is read again."""
    return _TEXTURE.sub(lambda found: _FILE.sub('texels = ("ffffff")', found[0]), head)


class _TooLong(Exception):
    """A step is to be done in smaller parts."""


class ProgressiveRenderer:
    """The picture of what was asked for last."""

    def __init__(self, glint):
        self._world, self._wanted, self._stages = World(glint), None, []
        self._row, self._pixel_seconds = 0, {"1": 2e-7}  # by samples
        self.picture = None  # float32 (height, width, 4), rows from the bottom; of another size than asked while it is coarse
        self.fault = ""  # why it cannot be shown

    @property
    def is_final(self):
        """Whether the picture has all its samples, or none will come."""
        return not self._stages

    @property
    def loads(self):
        """How often shapes were read."""
        return self._world.loads

    def ask(self, wanted):
        self._wanted, self._row = wanted, 0
        self._stages = self._plan(wanted)

    def step(self):
        """Renders a part. Does nothing if is_final."""
        if self.is_final:
            return
        scale, aa = self._stages[0]
        try:
            self._world.show(self._wanted.written)
            if self._whole_is_short(scale, aa):
                self.picture = self._timed(scale, aa, None)
                self._end_stage()
            else:
                self._render_band(aa)
            self.fault = ""
        except Exception as error:  # pylint: disable=broad-except
            self.fault, self._stages = str(error) or type(error).__name__, []  # for the viewport

    def _plan(self, wanted):
        """[(pixels of the viewport a side for one of the picture, samples)], the coarsest first."""
        scale = math.ceil(math.sqrt(self._pixel_seconds["1"] * wanted.size[0] * wanted.size[1] / STEP_SECONDS))
        stages = [(min(COARSEST, scale), "1")] if scale > 1 else []
        stages.append((1, "1"))
        return stages if wanted.aa == "1" else [*stages, (1, wanted.aa)]

    def _expected(self, aa):
        """Seconds for a pixel."""
        if aa not in self._pixel_seconds:
            samples = int("".join(c for c in aa if c.isdigit()) or 1)
            self._pixel_seconds[aa] = self._pixel_seconds["1"] * samples * samples
        return self._pixel_seconds[aa]

    def _whole_is_short(self, scale, aa):
        width, height = self._wanted.size
        return self._row == 0 and (scale > 1 or self._expected(aa) * width * height <= STEP_SECONDS)

    def _render_band(self, aa):
        width, height = self._wanted.size
        if self._row == 0:
            self.picture = _enlarged(self.picture, width, height)
        rows = max(1, int(STEP_SECONDS / (self._expected(aa) * width)))
        end = min(height, self._row + rows)
        try:
            band = self._timed(1, aa, (self._row, end))
        except _TooLong:  # where surfaces begin, below a background
            self._pixel_seconds[aa] *= 8
            return
        self.picture[height - end:height - self._row] = band
        self._row = end
        if end == height:
            self._end_stage()

    def _timed(self, scale, aa, rows):
        start = time.perf_counter()

        def stop_if_too_long(_fraction):
            if time.perf_counter() - start > LONGEST_SECONDS:
                raise _TooLong

        may_be_less = rows is not None and rows[1] - rows[0] > 1
        rgba = self._world.render(self._wanted, scale, aa, rows, stop_if_too_long if may_be_less else None)
        self._pixel_seconds[aa] = (time.perf_counter() - start) / (rgba.size // 4)
        return rgba

    def _end_stage(self):
        self._stages, self._row = self._stages[1:], 0


def _enlarged(picture, width, height):
    """A copy of a picture in another size, by its nearest pixels."""
    import numpy as np  # pylint: disable=import-outside-toplevel
    if picture is None:
        return np.zeros((height, width, 4), np.float32)
    rows, columns = (np.arange(n) * old // n for n, old in zip((height, width), picture.shape))
    return picture[rows][:, columns]
