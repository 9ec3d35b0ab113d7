# SPDX-License-Identifier: Apache-2.0
"""A scene of one object, in one line."""

from __future__ import annotations

from typing import Any, Optional, Tuple

from ._framing import Direction
from ._glint import Camera, Light, Material, Shape, Texture
from ._scene import Scene
from ._values import ColorLike, VectorLike


def show(
    *items: Any,
    direction: Direction = "iso",
    margin: float = 0.05,
    up: Optional[VectorLike] = None,
    size: Tuple[int, int] = (640, 480),
    background: Optional[ColorLike] = None,
    **options: Any,
) -> Scene:
    """A scene of objects, lit and framed, which a notebook shows at the end of a cell: glint.show(molecule).

    items: what Scene.add() takes: atoms of ASE, Open Babel or MDAnalysis, meshes of trimesh, pyvista or meshio, shapes;
    or one Scene, whose lights stay. direction, margin, up: as of Camera.fit(); size: (width, height) in pixels; background: by
    default white, or the Scene's; options:
    those of Scene.atoms() or Scene.mesh(), such as values= and colormap=. show(...).render().save('a.png') is a file,
    and show(...).show() a window.
    TypeError if an item is of another kind, ValueError if there is nothing to see.
    """
    if len(items) == 1 and isinstance(items[0], Scene) and not options:
        scene = items[0].copy()
        scene.settings["size"] = size
        if background is not None:
            scene.background = background  # type: ignore[assignment]
    else:
        scene = Scene(size=size, background="white" if background is None else background)
        own = (Camera, Light, Material, Shape, Texture)
        takes_options = [not isinstance(item, own) for item in items]
        for item, takes in zip(items, takes_options):
            scene.add(item, **(options if takes or not any(takes_options) else {}))
    scene.camera.fit(scene, direction, margin, up=up)
    scene._framed = None
    if not len(scene.lights):
        camera = scene.camera
        to_eye = camera.position - camera.look_at
        side = Scene(camera=camera.__copy__()).camera.orbit(-35, 25)
        scene.add(Light("ambient", color=0.6, name="ambient"))
        scene.add(Light("directional", to_light=to_eye, color=0.35, name="eye"))
        scene.add(Light("directional", to_light=side.position - side.look_at, color=0.6, name="side"))
    return scene
