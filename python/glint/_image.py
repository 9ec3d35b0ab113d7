# SPDX-License-Identifier: Apache-2.0
"""Pictures."""

from __future__ import annotations

import os
import warnings
from typing import IO, Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _glint
from ._expect import Closed, expect, plain
from ._files import write_file
from ._window import current_cell, show_picture
from ._words import PictureFormat, Transfer

FloatArray = npt.NDArray[np.float32]
PathLike = Union[str, "os.PathLike[str]"]


class _Layers(Mapping[str, FloatArray]):
    def __init__(self, rendering: _glint.Rendering, asked: Mapping[str, str]) -> None:
        self._rendering = rendering
        self._asked = asked

    def __getitem__(self, name: str) -> FloatArray:
        return self._rendering.layer(self._asked.get(name, name))

    def __iter__(self) -> Iterator[str]:
        return iter(self._rendering.layer_names())

    def __len__(self) -> int:
        return len(self._rendering.layer_names())

    def __reduce__(self) -> Tuple[Any, ...]:
        return dict, (dict(self),)

    def __repr__(self) -> str:
        shapes = (f"{name!r}: {' x '.join(map(str, layer.shape))}" for name, layer in self.items())
        return f"<layers {{{', '.join(shapes)}}}>"


class Image(Closed):
    """A picture: linear RGB floats, row by row from the top.

    Image(array) copies height x width x 3 (or 4) numbers, or height x width greys: floats, of which 1 is the
    brightest (whole numbers up to 255 raise ValueError), or uint8 or uint16, whose largest number it is. A PIL
    image is accepted as well. Image.open() reads a PNG, PPM, JPEG or OpenEXR file.
    """

    def __init__(self, picture: Any) -> None:
        self._rendering = _glint.Rendering(_to_array(picture))

    # The layers as render() was asked for them: a light's by its name, too.
    _asked: Mapping[str, str] = {}

    @classmethod
    def _of(cls, rendering: _glint.Rendering, asked: Sequence[str] = ()) -> Image:
        image = cls.__new__(cls)
        image._rendering = rendering
        image._asked = dict(zip(asked, rendering.layer_names()))
        return image

    @classmethod
    def open(cls, path: Union[PathLike, IO[bytes]], *, max_memory: int = 0) -> Image:
        """The picture of a file, by its name, or of an object with read(). Integers v are v / maximum; gamma is not decoded.

        max_memory: bytes that decoding may take; 0: 64 MiB, and 24 for each pixel.
        """
        read = getattr(path, "read", None)
        if read is not None:
            return cls._of(_glint.Rendering.decode(read(), max_memory))
        expect("path", path, Union[str, os.PathLike])
        with open(path, "rb") as file:  # type: ignore[arg-type]
            return cls._of(_glint.Rendering.decode(file.read(), max_memory))

    @property
    def array(self) -> FloatArray:
        """A view of the picture's floats, (height, width, 3), without a copy. Values are not limited to 1."""
        return self._rendering.array()

    def __array__(self, dtype: Optional[npt.DTypeLike] = None) -> npt.NDArray[Any]:
        return self.array if dtype is None else self.array.astype(dtype)

    @property
    def width(self) -> int:
        """In pixels."""
        return self._rendering.width

    @property
    def height(self) -> int:
        """In pixels."""
        return self._rendering.height

    @property
    def size(self) -> Tuple[int, int]:
        """(width, height) in pixels."""
        return self.width, self.height

    @property
    def layers(self) -> Mapping[str, FloatArray]:
        """The layers that render(aov=...) was asked for, by name: views of (height, width, channels). That of a
        light is called by its number, as 'light:2', and by the name that render() was given."""
        return _Layers(self._rendering, self._asked)

    @plain
    def viewable(self, layer: str) -> Image:
        """A layer as a picture to look at: normals as colors, depth from white to dark."""
        return Image._of(self._rendering.viewable(self._asked.get(layer, layer)))

    @property
    def rays(self) -> Dict[str, int]:
        """How many rays were traced: camera, shadow, mirror, transmitted, and cut ones, which were not."""
        return self._rendering.rays

    @property
    def isa(self) -> str:
        """The instruction set that it was rendered with; the picture does not depend on it."""
        return self._rendering.isa

    @plain
    def to_bytes(self, format: PictureFormat = "png", *, bits: int = 8, transfer: Optional[Transfer] = None) -> bytes:
        """The bytes of a file: 'png', 'ppm', 'tga', 'bmp', 'jpeg' or 'exr'. bits: 8 or 16 a channel (TGA, BMP and
        JPEG: 8); transfer: 'none' or 'srgb', in place of the scene's convention `transfer`."""
        return self._rendering.encode(format, bits, transfer)

    def save(
        self,
        path: Union[PathLike, IO[bytes]],
        format: Optional[PictureFormat] = None,
        *,
        bits: int = 8,
        transfer: Optional[Transfer] = None,
    ) -> None:
        """Writes .png, .ppm, .tga, .bmp, .jpg or .exr; an .exr holds the layers, too.

        path: a name, or an object with write(), such as io.BytesIO(). format: in place of the name's ending; of an
        object without a name, 'png' if it is None. The file is replaced when the new one is complete: if there is an
        error (OSError), the old one is as it was.
        """
        write = getattr(path, "write", None)
        name = str(getattr(path, "name", "")) if write is not None else os.fspath(path)  # type: ignore[arg-type]
        ending = os.path.splitext(name)[1].lower()
        if format is None and ending not in (".png", ".ppm", ".tga", ".bmp", ".jpg", ".jpeg", ".exr"):
            if write is None:
                raise ValueError(f"{name!r}: glint writes .png, .ppm, .tga, .bmp, .jpg and .exr")
            ending = ".png"
        known: Any = "jpeg" if ending == ".jpg" else ending[1:]
        content = self.to_bytes(known if format is None else format, bits=bits, transfer=transfer)
        if write is not None:
            write(content)
        else:
            write_file(name, content)

    @plain
    def to_uint8(self, *, transfer: Optional[Transfer] = None) -> npt.NDArray[np.uint8]:
        """The bytes of a PNG without alpha, (height, width, 3), in an array of its own. transfer: as of to_bytes().

        A picture that was rendered with alpha=True is shown on black.
        """
        if "alpha" in self._rendering.layer_names():
            colors = _glint.Rendering.decode(self.to_bytes(transfer=transfer), 0).array()
            alpha = np.clip(self._rendering.layer("alpha"), 0, 1)
            pixels: npt.NDArray[np.uint8] = np.rint(255 * colors * alpha).astype(np.uint8)
            return pixels
        content = self._rendering.encode("ppm", 8, transfer)
        count = 3 * self.width * self.height
        return np.frombuffer(content, np.uint8, count, len(content) - count).reshape(self.height, self.width, 3).copy()

    def to_pil(self) -> Any:
        """The same picture for PIL, with 8 bits a channel; RGBA if it was rendered with alpha=True."""
        import PIL.Image  # type: ignore[import]

        if "alpha" not in self._rendering.layer_names():
            return PIL.Image.fromarray(self.to_uint8())
        import io

        return PIL.Image.open(io.BytesIO(self.to_bytes()))

    def show(self) -> None:
        """Shows the picture: in a notebook below the cell, else by the system's program for PNG files or the browser, from a
        temporary file. A GlintWarning has the file's name if there is no display, or no such program."""
        self._cell = None
        show_picture(self)
        self._cell = current_cell()

    # The cell of a notebook that has shown it, at whose end `scene.show()` shows it no second time.
    _cell: Optional[int] = None

    def _repr_png_(self) -> Optional[bytes]:
        if self._cell is not None and self._cell == current_cell():
            return None
        return self.to_bytes()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Image) and np.array_equal(self.array, other.array)

    __hash__ = None  # type: ignore[assignment]

    def __copy__(self) -> Image:
        image = Image._of(self._rendering.copy())
        image._asked = self._asked
        return image

    def __deepcopy__(self, memo: Dict[int, Any]) -> Image:
        return self.__copy__()

    def __reduce__(self) -> Tuple[Any, ...]:
        return Image, (self.array,)

    def __repr__(self) -> str:
        layers: List[str] = self._rendering.layer_names()
        return f"<glint.Image {self.width}x{self.height}{', layers ' + ', '.join(layers) if layers else ''}>"


def _to_array(picture: Any) -> FloatArray:
    if not isinstance(picture, np.ndarray) and hasattr(picture, "convert") and hasattr(picture, "mode"):
        picture = picture.convert("RGB")  # PIL's
    if isinstance(picture, (str, os.PathLike)):
        raise TypeError(f"Image() takes an array; glint.Image.open({os.fspath(picture)!r}) reads a file")
    array = np.asarray(picture)
    if array.ndim in (2, 3) and (array.dtype.kind == "i" or (array.dtype.kind == "u" and array.dtype.itemsize > 2)):
        # What 1 is cannot be known: 255 in many programs, whose arrays are NumPy's own int64.
        raise TypeError(
            f"a picture of whole numbers is an array of uint8 (0 to 255) or uint16 (0 to 65535), found {array.dtype}: "
            "convert it, as by astype(np.uint8), or divide it to floats from 0 to 1"
        )
    if array.dtype.kind in "ui":
        array = array.astype(np.float32) / np.float32(np.iinfo(array.dtype).max)
    if array.ndim == 2:
        array = np.repeat(array[:, :, np.newaxis], 3, axis=2)
    if array.ndim == 3 and array.shape[2] == 4:
        array = array[:, :, :3]
    if array.ndim != 3 or array.shape[2] != 3:
        shape = " x ".join(map(str, array.shape))
        raise ValueError(f"a picture is an array of height x width x 3 numbers, found {shape or 'one number'}")
    floats = np.ascontiguousarray(array, dtype=np.float32)
    most = float(floats.max(initial=0))
    if array.dtype.kind == "f" and 16 <= most <= 255:
        # Almost all of it would be white. Bright light of whole numbers alone does not occur.
        if np.array_equal(floats, np.rint(floats)):
            raise ValueError(
                f"the numbers of a picture of floats are from 0 to 1, found whole numbers up to {most:g}: "
                "divide them by 255, or convert them, as by astype(np.uint8)"
            )
        if np.count_nonzero(floats > 1) > floats.size / 2:
            warnings.warn(
                "most numbers of this picture of floats are above 1, which is white: if 255 is the brightest, divide them by it",
                stacklevel=3,
            )
    return floats


def to_image(picture: Any) -> Image:
    """Of an Image, the path of a file, a PIL image or an array."""
    if isinstance(picture, Image):
        return picture
    if isinstance(picture, (str, os.PathLike)):
        return Image.open(picture)
    return Image(picture)
