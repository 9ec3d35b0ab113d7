# SPDX-License-Identifier: Apache-2.0
"""Reading scenes, and questions about scenes and pictures."""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
from typing import IO, Any, List, Mapping, Optional, Sequence, Tuple, Union

from . import _glint
from ._expect import expect, plain
from ._files import read_source, write_file
from ._framing import frame_unset
from ._html import shrunk
from ._html_pixel import PixelView
from ._image import Image, PathLike, to_image
from ._progress import Progress, reporting
from ._reports import Comparison, Explanation
from ._scene import Scene
from ._settings import profiles, to_list
from ._words import Shading

SceneLike = Union[Scene, PathLike]
View = Union[None, str, Sequence[float]]


def _load(
    texts: List[Tuple[str, bytes, str]],
    scene_name: str,
    profile: str,
    settings: Mapping[str, object],
    convention: Optional[Mapping[str, object]],
    folders: List[str],
    includes: str,
    max_memory: int,
    skip_unsupported: bool,
    view: View,
    progress: Progress,
) -> Scene:
    profile_text = None
    if profile and profile not in profiles:
        profile_text = profile, pathlib.Path(profile).read_bytes()
        profile = ""
    scene = Scene()
    scene._framed = None  # the camera is the file's
    with reporting(progress) as report:
        scene._state.load_texts(
            texts,
            scene_name,
            profile,
            profile_text,
            to_list(convention or {}) + to_list(settings),
            max_memory,
            folders,
            includes,
            skip_unsupported,
            view if isinstance(view, str) else ",".join(str(float(x)) for x in view or ()),
            report,
        )
    return scene


@plain
def load(
    *paths: Union[PathLike, IO[bytes], IO[str]],
    format: str = "",
    scene_name: str = "",
    include_path: Union[PathLike, Sequence[PathLike]] = (),
    profile: str = "",
    convention: Optional[Mapping[str, object]] = None,
    size: Union[None, Tuple[int, int], str] = None,
    aa: Union[None, int, str] = None,
    shading: Optional[Shading] = None,
    reflections: Optional[int] = None,
    shadows: Optional[bool] = None,
    alpha: Optional[bool] = None,
    seed: Optional[int] = None,
    max_memory: int = 0,
    skip_unsupported: bool = False,
    view: View = None,
    progress: Progress = None,
) -> Scene:
    """The scene of one file, or of several together: .cgfs, .json, .js, .pov, .nff, .dat, .ply, .stl, .obj,
    .gltf, .glb or .glint.

    paths: names, or objects with read(), such as io.BytesIO(). An object that is no file on a disk includes only
    files in the working folder, or in the folder of its name, and in include_path.
    The keywords are the options of the command. format: if the file's name does not tell; scene_name: of a
    file that holds several; include_path: a folder, or several, with files that the scene includes and that are
    not beside it; profile: one of glint.profiles, or a file of `key = value` lines. max_memory: bytes that
    reading may take; 0: 2 GiB and 256 times the length of the texts. skip_unsupported: objects that glint does not
    render are left out, with warnings that name and count them; else they are errors. view: where a mesh without
    a camera is seen from: 'front', 'iso', or the direction (x, y, z) from the mesh to the eye.
    Raises GlintError with the place of each mistake, FileNotFoundError, and MemoryError beyond max_memory, with
    the place.
    """
    if not paths:
        raise TypeError("load() needs the path of a scene")
    sources = [read_source(path, "file") for path in paths]
    texts = [(name, content, format) for name, content, _ in sources]
    settings = dict(
        size=size, aa=aa, shading=shading, reflections=reflections, shadows=shadows, alpha=alpha, seed=seed
    )
    folders = _folders(include_path)
    return _load(
        texts,
        scene_name,
        profile,
        settings,
        convention,
        folders,
        "any" if all(is_on_disk for *_, is_on_disk in sources) else "folder",
        max_memory,
        skip_unsupported,
        view,
        progress,
    )


def _folders(include_path: Union[PathLike, Sequence[PathLike]]) -> List[str]:
    paths = [include_path] if isinstance(include_path, (str, os.PathLike)) else include_path
    return [os.fspath(path) for path in paths]


@plain
def loads(
    text: str,
    format: str = "glint",
    *,
    name: str = "text",
    scene_name: str = "",
    profile: str = "",
    includes: bool = True,
    include_path: Union[PathLike, Sequence[PathLike]] = (),
    max_memory: int = 0,
    skip_unsupported: bool = False,
    view: View = None,
) -> Scene:
    """The scene of a text: 'cgfs', 'epfl', 'csc473', 'povray', 'nff', 'tachyon', 'ply', 'stl', 'obj',
    'gltf' or 'glint'.

    name: for messages; a file that the text includes is looked for beside a file of this name, then in
    include_path, a folder or several, and never outside of these folders. includes: False: no file is read.
    max_memory, skip_unsupported, view: as of load().
    """
    expect("text", text, str)
    texts = [(name, text.encode(), format)]
    reach = "folder" if includes else "none"
    folders = _folders(include_path)
    return _load(
        texts, scene_name, profile, {}, None, folders, reach, max_memory, skip_unsupported, view, None
    )


def to_scene(scene: SceneLike, size: Union[None, Tuple[int, int], str] = None) -> Scene:
    if not isinstance(scene, Scene):
        return load(scene)
    frame_unset(scene, size)
    return scene


@plain
def explain(
    scene: SceneLike,
    x: int,
    y: int,
    *,
    size: Union[None, Tuple[int, int], str] = None,
    aa: Union[None, int, str] = None,
    shading: Optional[Shading] = None,
    reflections: Optional[int] = None,
    shadows: Optional[bool] = None,
    seed: Optional[int] = None,
    convention: Optional[Mapping[str, object]] = None,
    sample: Optional[int] = None,
    fold: float = 0.5,
) -> Explanation:
    """Why pixel (x, y), from the top left, has its color: its rays and each term of their light.

    The result has them as attributes, and as the text that `glint explain` prints. The other keywords are those
    of Scene.render(). sample: which of N x N the text is about; default: the middle one. fold: in the text,
    secondary rays that add less than this, in 255ths, are one line; 0: all are printed.
    """
    if not fold >= 0:
        raise ValueError(f"fold must be 0 or more, not {fold}")
    settings = dict(size=size, aa=aa, shading=shading, reflections=reflections, shadows=shadows, seed=seed)
    listed = to_list(settings) + to_list(convention or {})
    scene = to_scene(scene, size)
    with scene._rendering:
        data, text = scene._state.explain(x, y, listed, sample, fold, None)
    explanation = Explanation(json.loads(data), text)
    explanation._view = PixelView(scene, (x, y), {**settings, "convention": convention})
    explanation._sample = sample
    return explanation


@dataclasses.dataclass(frozen=True)
class Finding:
    """A likely mistake of a scene."""

    id: str
    """Such as 'camera-inside-shape'; docs/checks.md explains each."""
    message: str
    remedy: str
    diagnostic: _glint.Diagnostic
    """Its place and its severity: 'warning', or 'note' if the picture is as it should be all the same."""
    text: str

    def __str__(self) -> str:
        return self.text


def check(scene: SceneLike, *, progress: Progress = None) -> List[Finding]:
    """The scene's likely mistakes: what can be rendered, and is hardly what was meant."""
    scene = to_scene(scene)
    with scene._rendering, reporting(progress) as report:
        found = scene._state.check(report)
    return [Finding(id, d.message, remedy, d, text) for id, d, remedy, text in found]


@plain
def compare(
    a: Any,
    b: Any,
    scene: Optional[SceneLike] = None,
    *,
    causes: bool = True,
    as_floats: bool = False,
    within: float = 2.0,
    max_memory: int = 0,
    progress: Progress = None,
) -> Comparison:
    """How picture a differs from the reference b, and why: Images, paths, PIL images or arrays.

    scene: which renders b; with it, more causes are tried. as_floats: compares floats, not bytes. within: in
    255ths, for the figures. max_memory: bytes that the comparison may take beyond the pictures, for the figures
    and again for the causes; 0: what they usually need. MemoryError is raised if they need more.
    """
    first, second = to_image(a), to_image(b)
    names = [str(p) if isinstance(p, (str, os.PathLike)) else n for p, n in ((a, "a"), (b, "b"))]
    with reporting(progress) as report:
        data, text = _glint.compare(
            first._rendering,
            second._rendering,
            names[0],
            names[1],
            None if scene is None else to_scene(scene)._state,
            causes,
            as_floats,
            within,
            max_memory,
            report,
        )
    comparison = Comparison(json.loads(data), text)
    comparison.difference = Image._of(_glint.difference(first._rendering, second._rendering, 0.0))
    comparison._shown = tuple(shrunk(image) for image in (first, second, comparison.difference))
    return comparison


@dataclasses.dataclass(frozen=True)
class Versus:
    """A scene by two sets of rules."""

    a: Image
    b: Image
    comparison: Comparison
    explanations: Tuple[Explanation, Explanation]
    """Of the pixel that differs most."""

    def __str__(self) -> str:
        return f"{self.comparison}\nA: {self.explanations[0]}\nB: {self.explanations[1]}"

    def _repr_html_(self) -> str:
        return "<hr>".join(part._repr_html_() for part in (self.comparison, *self.explanations))


def versus(scene: SceneLike, a: Mapping[str, object] = {}, b: Mapping[str, object] = {}) -> Versus:
    """Renders a scene with two sets of settings and conventions, and explains the pixel that differs most.

    a, b: mappings such as {'shading': 'phong'} or {'profile': 'cgfs'}; a profile replaces all of the scene's
    rules, but not its size.
    """
    scene = to_scene(scene)
    sides = []
    for settings in (a, b):
        side = scene.copy()
        profile = settings.get("profile")
        if profile is not None:
            size = side.settings["size"]
            side.use_profile(str(profile))
            side.settings["size"] = size
        for key, value in settings.items():
            if key != "profile":
                side._state.set_setting(key, to_list({key: value})[0][1])
        sides.append(side)
    images = [side.render() for side in sides]
    comparison = compare(images[0], images[1], causes=False)
    at = comparison.data["largest"]
    return Versus(
        images[0],
        images[1],
        comparison,
        (explain(sides[0], at["x"], at["y"]), explain(sides[1], at["x"], at["y"])),
    )


def convert(source: SceneLike, target: PathLike) -> None:
    """Writes a scene to a file: in glint's own language to a .glint, or as glTF to a .glb or .gltf.

    The names of textures' files become relative to the folder of a .glint. Of glTF, a GlintWarning names each kind of things
    that it does not have.
    """
    name = os.fspath(target)
    formats = {extension: format for format, extension, _ in _glint.written_formats()}
    format = formats.get(os.path.splitext(name)[1].lower())
    if format is None:
        raise ValueError(f"{name!r}: glint writes {', '.join(formats)}")
    scene = to_scene(source)
    if format != "glint":
        write_file(name, scene._state.write_scene(format))
        return
    if any(texture.file for texture in scene.textures):
        scene = scene.copy()
        for texture in scene.textures:
            if texture.file and not os.path.isabs(texture.file):
                texture.file = os.path.relpath(texture.file, os.path.dirname(name) or ".")
    write_file(name, scene.to_glint().encode())
