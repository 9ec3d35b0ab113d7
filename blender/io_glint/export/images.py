# SPDX-License-Identifier: Apache-2.0
"""What exports need of Blender's images: their means, and files that glint reads. Both are kept until an image changes."""
import array
import hashlib
import os
import re

from . import png
from .files import write_new
from .png import np

MEAN_SAMPLES = 65536
DATA_SPACES = ("Non-Color", "Raw", "Generic Data")  # alpha is not multiplied into the colors of these
LINEAR_SPACES = ("Linear", "Linear Rec.709", *DATA_SPACES)
SPACES = ("sRGB", *LINEAR_SPACES)
_MAGIC = {b"\x89PNG\r\n\x1a\n": ".png", b"\xff\xd8\xff": ".jpg"}  # what glint decodes as Blender does


class Images:
    """One for an export, or for all pictures of a viewport. folder: where textures' files are written, made when it is needed;
    None: nowhere. shown: its name in the scene's text."""

    def __init__(self, folder=None, shown=""):
        self.folder, self.shown, self._known = folder, shown, {}

    def forget(self, name):
        """An image has changed."""
        for key in [key for key in self._known if key[0] == name]:
            del self._known[key]

    def mean(self, image):
        """The mean linear color and the mean alpha of an image, four numbers, from evenly spaced pixels; None if it has none."""
        return None if image is None else self._once(image, "mean", lambda: mean_pixel(image))

    def file(self, image, variant):
        """(the file's name in the text, its encoding, what its colors are to be multiplied by) of an image under a Variant; a text
        that says why there is none."""
        return self._once(image, variant, lambda: self._write(image, variant))

    def _once(self, image, kind, make):
        key = (image.name_full, kind)
        state = _state(image)
        if key not in self._known or self._known[key][0] != state:
            self._known[key] = state, make()
        return self._known[key][1]

    def _write(self, image, variant):
        made = content(image, variant)
        if isinstance(made, str):
            return made
        data, extension, encoding, factor = made
        digest = hashlib.blake2b(data, digest_size=6).hexdigest()
        stem = re.sub(r"[^\w-]", "_", os.path.splitext(image.name)[0], flags=re.ASCII)[:40]
        name = f"{stem}_{digest}{extension}"
        write_new(self.folder, name, data)
        return f"{self.shown}/{name}", encoding, factor


def _path(image):
    return image.filepath_from_user() if image.source == "FILE" else ""


def _state(image):
    """What differs when the image has other pixels: Blender says of edits in the interface only that they were made."""
    path = _path(image)
    try:
        time = os.stat(path).st_mtime_ns if path else 0
    except OSError:
        time = 0
    return (image.as_pointer(), path, time, image.source, image.is_dirty, image.alpha_mode, image.colorspace_settings.name,
            tuple(image.size), tuple(image.generated_color), image.generated_type)


def _pixels(image):
    """An array of all channels' floats, rows from the bottom; None for an image without pixels."""
    if not image.has_data and not image.size[0] or not image.channels:
        return None
    values = array.array("f", bytes(4 * len(image.pixels)))
    if values:
        image.pixels.foreach_get(values)
    return values or None


def _linear(c):
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


def mean_pixel(image):
    pixels = _pixels(image)
    if pixels is None:
        return None
    n = image.channels
    step = max(1, image.size[0] * image.size[1] // MEAN_SAMPLES)
    mean = []
    for channel in range(min(n, 4)):
        values = pixels[channel::n * step]
        if channel < 3 and not image.is_float and image.colorspace_settings.name == "sRGB":
            values = [_linear(v) for v in values]
        mean.append(sum(values) / len(values))
    if len(mean) < 3:
        mean = [mean[0]] * 3
    return (*mean[:3], mean[3] if len(mean) > 3 else 1.0)


class Variant(tuple):
    """What a texture takes of an image: (color, alpha, border): whether it takes its colors (else white), whether it takes its
    alpha, and whether the image ends in black and transparency."""

    def __new__(cls, color=True, alpha=False, border=False):
        return super().__new__(cls, (color, alpha, border))


def content(image, variant):
    """(bytes of a picture's file, its extension, the texture's encoding, what its colors are to be multiplied by), or a text that
    says why there are none.

    As in Cycles, an image whose alpha is not used has colors that are multiplied by it, as they are encoded."""
    color, alpha, border = variant
    space = image.colorspace_settings.name
    if space not in SPACES:
        return f"its color space is {space}"
    encoding = "srgb" if space == "sRGB" else "linear"
    # A file without alpha has the depth 24; what is made or edited in Blender has alpha, whatever its depth.
    may_have_alpha = image.alpha_mode != "NONE" and (image.source == "GENERATED" or image.is_dirty
                                                     or image.depth // (4 if image.is_float else 1) in (16, 32))
    darkens = may_have_alpha and not alpha and image.alpha_mode != "CHANNEL_PACKED" and space not in DATA_SPACES
    if color and not border and not image.is_dirty:
        data, extension = _stored(image)
        if extension and not (darkens and _has_holes(image)):
            return data, extension, encoding, 1.0
    if np is None:
        return "writing it needs numpy"
    values = _pixels(image)
    if values is None:
        return "it has no pixels"
    width, height = image.size
    texels = np.frombuffer(values, np.float32).reshape(height, width, image.channels)[::-1]
    if image.channels < 3:
        texels = np.concatenate([texels[..., :1]] * 3 + [texels[..., 1:]], 2)
    rgb = texels[..., :3]
    opacity = texels[..., 3:] if texels.shape[2] > 3 and may_have_alpha else np.ones_like(rgb[..., :1])
    factor = 1.0
    if image.is_float:  # linear, and multiplied by alpha, whatever the color space of the file
        encoding = "linear"
        rgb = np.nan_to_num(rgb)
        if not darkens:
            rgb = rgb / np.maximum(opacity, 1e-6)
        factor = max(1.0, float(rgb.max()))
        rgb = rgb / np.float32(factor)
    elif darkens:
        rgb = rgb * opacity
    if not color:
        rgb, encoding, factor = np.ones_like(rgb), "linear", 1.0
    if alpha:
        rgb = np.concatenate([rgb, opacity], 2)
    if border:
        rgb = np.pad(rgb, ((1, 1), (1, 1), (0, 0)))
    return png.encoded(rgb, 16 if image.is_float else 8), ".png", encoding, factor


def _stored(image):
    """(bytes, extension) of the file that an image was read from, if glint reads it as well; (None, "") otherwise."""
    if image.source != "FILE":
        return None, ""
    try:
        if image.packed_file is not None:
            data = bytes(image.packed_file.data)
        else:
            with open(_path(image), "rb") as file:
                data = file.read()
    except OSError:
        return None, ""
    return next(((data, extension) for magic, extension in _MAGIC.items() if data.startswith(magic)), (None, ""))


def _has_holes(image):
    pixels = _pixels(image)
    if pixels is None or image.channels != 4:
        return False
    alphas = pixels[3::4]
    return min(alphas) < 1 if np is None else bool((np.frombuffer(pixels, np.float32)[3::4] < 1).any())
