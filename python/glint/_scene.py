# SPDX-License-Identifier: Apache-2.0
"""The scene."""

from __future__ import annotations

import dataclasses
import warnings
from typing import Any, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, TypeVar, Union, overload

import numpy as np
import numpy.typing as npt

from . import _accept, _glint
from ._expect import expect, plain
from ._framing import CountedImages, frame_unset
from ._glint import BackgroundGradient, Camera, Fog, Light, Material, Occlusion, Shape, Texture
from ._image import Image
from ._lists import Lights, Materials, Shapes, Textures
from ._many import Arrays, ManyShapes
from ._progress import Progress, reporting
from ._settings import Settings, to_crop, to_list
from ._views import ShownScene
from ._values import Color, ColorLike, Vec3
from ._words import SceneFormat, Shading

Added = TypeVar("Added", bound=Union[Light, Material, Shape, Texture])


@dataclasses.dataclass(frozen=True)
class Hits:
    """What rays hit first, by ray."""

    t: npt.NDArray[np.float64]
    """(N,): the hit is at origin + t direction; infinity if there is none."""
    shape: npt.NDArray[np.int64]
    """(N,): an index in scene.shapes; -1 if there is no hit."""
    point: npt.NDArray[np.float64]
    """(N, 3): the hit; NaN if there is none."""
    normal: npt.NDArray[np.float64]
    """(N, 3): the shape's own unit normal; 0 if there is no hit."""

    @property
    def hit(self) -> npt.NDArray[np.bool_]:
        """(N,): whether there is a hit."""
        return self.shape >= 0

    def __len__(self) -> int:
        return len(self.t)


class Scene(ManyShapes, ShownScene):
    """Shapes, materials, lights, a camera, conventions and settings.

    The next picture prepares only what has changed since the last one: a new light, material or camera takes
    microseconds. Any thread may change the scene while another one renders it; a picture shows the scene as
    it was when render() was called.
    """

    def __init__(
        self,
        *items: Any,
        size: Optional[Tuple[int, int]] = None,
        background: Optional[ColorLike] = None,
        camera: Optional[Camera] = None,
        fog: Optional[Fog] = None,
        gradient: Optional[BackgroundGradient] = None,
        occlusion: Optional[Occlusion] = None,
    ) -> None:
        self._state = _glint.SceneState()
        self._framed: Optional[Camera] = self._state.camera.__copy__()
        if size is not None:
            self.settings["size"] = size
        if background is not None:
            self.background = background  # type: ignore[assignment]
        if camera is not None:
            self.camera = camera
        if fog is not None:
            self.fog = fog
        if gradient is not None:
            self.gradient = gradient
        if occlusion is not None:
            self.occlusion = occlusion
        for item in items:
            self.add(item)

    # ---- Contents ----

    @property
    def lights(self) -> Lights:
        """The lights, by number or by name: scene.lights['key'].intensity *= 2."""
        return Lights(self._state)

    @lights.setter
    def lights(self, lights: Iterable[Light]) -> None:
        items = list(lights)
        for light in items:
            expect("lights", light, Light)
        self._state.set_lights(items)

    @property
    def materials(self) -> Materials:
        """The materials, by number or by name."""
        return Materials(self._state)

    @property
    def textures(self) -> Textures:
        """The textures, by number or by name: those of the materials, and those that were added."""
        return Textures(self._state)

    @property
    def shapes(self) -> Shapes:
        """The shapes, by number or by name."""
        return Shapes(self._state)

    @property
    def camera(self) -> Camera:
        """The camera: scene.camera.position = (0, 1, 5).

        Until it is set or changed, each picture of a scene made in Python frames all shapes, seen from (1, 1, 1), as
        scene.camera.fit(scene) does. A scene that was read from a file has the file's camera.
        """
        return self._state.camera

    @camera.setter
    def camera(self, camera: Camera) -> None:
        expect("camera", camera, Camera)
        self._state.camera = camera
        self._framed = None

    @property
    def bounds(self) -> Optional[Tuple[Vec3, Vec3]]:
        """(min, max), the least and the greatest coordinates of all shapes in world space, a little rounded outwards;
        None if there are none. Planes without bounds do not count."""
        return self._state.bounds()

    @property
    def background(self) -> Color:
        """The color where nothing is hit, linear RGB."""
        return self._state.background

    @background.setter
    def background(self, color: ColorLike) -> None:
        self._state.background = color

    @property
    def fog(self) -> Optional[Fog]:
        """The fog, or None: scene.fog = glint.Fog('exp', color=0.7, density=0.05)."""
        return self._state.fog

    @fog.setter
    def fog(self, fog: Optional[Fog]) -> None:
        expect("fog", fog, Optional[Fog])
        self._state.fog = fog

    @property
    def gradient(self) -> Optional[BackgroundGradient]:
        """The gradient in place of the background, or None: scene.gradient = glint.BackgroundGradient(up=(0, 0, 1))."""
        return self._state.gradient

    @gradient.setter
    def gradient(self, gradient: Optional[BackgroundGradient]) -> None:
        expect("gradient", gradient, Optional[BackgroundGradient])
        self._state.gradient = gradient

    @property
    def occlusion(self) -> Optional[Occlusion]:
        """The light from all directions, or None: scene.occlusion = glint.Occlusion(samples=64, direct=0.5)."""
        return self._state.occlusion

    @occlusion.setter
    def occlusion(self, occlusion: Optional[Occlusion]) -> None:
        expect("occlusion", occlusion, Optional[Occlusion])
        self._state.occlusion = occlusion

    @property
    def conventions(self) -> Settings:
        """The rules on which sources disagree, by key (docs/conventions.md); can be changed."""
        return Settings(self._state, True)

    @property
    def settings(self) -> Settings:
        """size, shading, shadows, reflections, aa, alpha and seed, where render() is not told otherwise; can be changed."""
        return Settings(self._state, False)

    @property
    def profile(self) -> str:
        """The source whose conventions it began with: 'glint', 'epfl', ..."""
        return self._state.profile

    @plain
    def use_profile(self, name: str) -> None:
        """Sets all conventions and settings to those of a source, one of glint.profiles."""
        self._state.apply_profile(name)

    @property
    def files(self) -> List[str]:
        """The names of the files that it was read from."""
        return self._state.files

    @overload
    def add(self, item: Added) -> Added: ...
    @overload
    def add(self, item: Camera) -> Camera: ...
    @overload
    def add(self, item: Any, **options: Any) -> Any: ...

    def add(self, item: Any, **options: Any) -> Any:
        """Adds a shape, a light, a material, a texture or a camera, and returns it: later changes of it are seen.

        Also (symbols, positions) and atoms of ASE, Open Babel and MDAnalysis (see atoms()), a surface(), and meshes of
        trimesh, pyvista and meshio (see mesh()); these return the range of their shapes' numbers.
        """
        if options and isinstance(item, (Light, Material, Texture, Shape, Camera)):
            raise TypeError(f"add() takes no keywords with a {type(item).__name__}, which has attributes; found {', '.join(options)}")
        if isinstance(item, Light):
            self._state.add_light(item)
        elif isinstance(item, Material):
            self._state.add_material(item)
        elif isinstance(item, Texture):
            self._state.add_texture(item)
        elif isinstance(item, Shape):
            self._state.add_shape(item)
        elif isinstance(item, Camera):
            self.camera = item
        elif _accept.is_atoms(item):
            return self.atoms(item, **options)
        elif _accept.is_mesh(item):
            return self.mesh(item, **options)
        else:
            hint = "; spheres(centers, radii) adds points" if isinstance(item, np.ndarray) else ""
            hint = "; add them one by one" if isinstance(item, (list, tuple)) else hint
            raise TypeError(f"glint cannot add {type(item).__name__!r} to a scene{hint}")
        return item

    # ---- Pictures and questions ----

    @plain
    def render(
        self,
        *,
        size: Union[None, Tuple[int, int], str] = None,
        aa: Union[None, int, str] = None,
        shading: Optional[Shading] = None,
        reflections: Optional[int] = None,
        shadows: Optional[bool] = None,
        alpha: Optional[bool] = None,
        seed: Optional[int] = None,
        convention: Optional[Mapping[str, object]] = None,
        aov: Union[str, Sequence[str]] = (),
        crop: Union[None, Tuple[int, int, int, int], str] = None,
        threads: int = 0,
        isa: str = "",
        progress: Progress = None,
    ) -> Image:
        """The picture. The keywords are the options of the command; None is what scene.settings has.

        size: (width, height) in pixels; aa: N x N samples a pixel, or 'adaptive:N:T', both also with ':jitter' at
        the end; shading: 'phong', 'blinn-phong', 'diffuse', 'color' or 'normals'; reflections: the largest number
        in succession; alpha: True for a transparent background, which PNG and EXR files then have (the layer
        'alpha' is added to aov); seed: another number samples other places; convention: changes for this picture
        alone; aov: names of layers, or 'all'; 'light:NAME', or 'light:2' for scene.lights[1], is the picture with
        this light alone; crop: (width, height, x, y) or 'WIDTHxHEIGHT+X+Y', a part of the picture; threads: 0 for all, which changes
        nothing in the picture. progress: True for a bar, or a function that is called with the fraction done.
        Ctrl-C stops it.
        """
        settings = to_list(
            dict(
                size=size,
                aa=aa,
                shading=shading,
                reflections=reflections,
                shadows=shadows,
                alpha=alpha,
                seed=seed,
            )
        ) + to_list(convention or {})
        expect("aov", aov, Union[str, Sequence[str]])
        if aov == "all":
            aov = [info[0] for info in _glint.layer_infos()]
        elif isinstance(aov, str):
            aov = aov.split(",")
        with self._rendering, reporting(progress) as report:
            frame_unset(self, size)
            return Image._of(
                self._state.render(settings, list(aov), to_crop(crop), threads, isa, report), list(aov)
            )

    @plain
    def cast(
        self, origins: Arrays, directions: Arrays, *, t_min: float = 0.0, t_max: float = float("inf")
    ) -> Hits:
        """What rays hit first: origins and directions are (N, 3), or (3,) for one that all share.

        A hit is at origin + t direction with t_min < t < t_max; directions have any length but 0.
        """
        with self._rendering:
            return Hits(*self._state.cast_rays(origins, directions, t_min, t_max, None))

    def to_glint(self) -> str:
        """The scene in glint's own language (docs/formats/glint.md): load() makes the same picture of it.

        Textures that were read from files are written as the names of these files (Texture.file), others as texels.
        """
        frame_unset(self)
        return self._state.write_glint()

    @plain
    def to_bytes(self, format: SceneFormat = "glb") -> bytes:
        """A file of the scene for other programs: "glb" or "gltf" (docs/formats/gltf.md), or "glint".

        A GlintWarning names each kind of things that the format does not have.
        """
        frame_unset(self)
        return self._state.write_scene(format)

    def turntable(self, frames: int = 36, **options: Any) -> Iterator[Image]:
        """Pictures of one turn around the point that the camera looks at, one after the other, from where it is.

        frames: how many; options: those of render(). The camera is then where it was.
        glint.animate(scene.turntable(60), 'turn.gif') is a film.
        """
        expect("frames", frames, int)
        return CountedImages(self._turn(frames, options), frames)

    def _turn(self, frames: int, options: Mapping[str, Any]) -> Iterator[Image]:
        frame_unset(self, options.get("size"))
        turned = self.copy()
        turned._framed = None
        for _ in range(frames):
            yield turned.render(**options)
            turned.camera.orbit(360 / frames)

    def copy(self) -> Scene:
        """A scene of its own, with objects of its own; what was prepared is shared."""
        copy = type(self).__new__(type(self))
        copy._state = _glint.SceneState()
        copy._state.copy_from(self._state)
        copy._framed = self._framed
        return copy

    def __copy__(self) -> Scene:
        return self.copy()

    def __deepcopy__(self, memo: Dict[int, Any]) -> Scene:
        return self.copy()

    def __reduce__(self) -> Tuple[Any, ...]:
        frame_unset(self)
        return _unpickled, (self._state.write_whole_glint(),)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self._state.equals(other._state)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        def counted(count: int, noun: str) -> str:
            return f"{count} {noun}{'' if count == 1 else 's'}"

        state = self._state
        name = ", ".join(self.files)
        contents = ", ".join(
            (
                counted(state.shape_count(), "shape"),
                counted(state.material_count(), "material"),
                counted(state.light_count(), "light"),
            )
        )
        return f"<glint.Scene {name + ': ' if name else ''}{contents}>"


def _unpickled(text: str) -> Scene:
    from ._tools import loads

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # issued where the scene was made
        return loads(text)
