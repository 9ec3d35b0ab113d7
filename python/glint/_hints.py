# SPDX-License-Identifier: Apache-2.0
"""What names of other programs are called here: for messages about names that glint does not have."""

from __future__ import annotations

from typing import Dict

_PICTURE = "scene.render().save('a.png') for a picture, and glint.convert(scene, 'a.glb') for the scene"
_REMOVE = "del scene.shapes[number]"

_ATTRIBUTES: Dict[str, Dict[str, str]] = {
    "Scene": {
        "save": _PICTURE, "write": _PICTURE, "export": _PICTURE, "screenshot": _PICTURE, "remove": _REMOVE, "delete": _REMOVE,
        "add_light": "scene.add(light)", "add_sphere": "scene.add(glint.Sphere(center, radius))",
        "add_points": "scene.spheres(centers, radii)", "scatter": "scene.spheres(centers, radii)", "ray": "scene.cast()",
        "intersect": "scene.cast()", "ray_intersect": "scene.cast()", "explain": "glint.explain(scene, x, y)",
        "check": "glint.check(scene)", "compare": "glint.compare(a, b, scene)",
    },
    "Image": {
        "shape": "image.array.shape", "numpy": "image.array", "to_numpy": "image.array", "pixels": "image.array",
        "resize": "scene.render(size=...), or image.to_pil().resize()", "crop": "scene.render(crop=...)",
    },
    "Camera": {
        "origin": "position", "eye": "position", "target": "look_at", "focal_point": "look_at", "view_angle": "fov",
        "viewup": "up", "dolly": "zoom()", "Zoom": "zoom()", "Azimuth": "orbit(right=...)", "azimuth": "orbit(right=...)",
        "Elevation": "orbit(up=...)", "elevation": "orbit(up=...)", "reset": "fit(scene)",
    },
    "Light": {
        "brightness": "intensity", "strength": "intensity", "energy": "intensity",
        "direction": "to_light, which points to the light, or axis of a spot", "target": "axis of a spot",
    },
    "Material": {
        "roughness": "shininess, which is larger for smooth surfaces", "opacity": "transmission, which is 1 - opacity",
        "alpha": "transmission, which is 1 - alpha", "reflectivity": "mirror", "reflection": "mirror",
        "metalness": "metallic", "specular_power": "shininess",
    },
    "Sphere": {"r": "radius"},
    "Box": {"center": "min and max", "size": "min and max"},
}  # fmt: skip

_KEYWORDS = {
    "spp": "aa=4, which is 4 x 4 samples a pixel", "samples": "aa=4, which is 4 x 4 samples a pixel",
    "width": "size=(width, height)", "height": "size=(width, height)", "resolution": "size=(width, height)",
    "window_size": "size=(width, height)", "c": "colors or values", "color": "colors", "cmap": "colormap",
    "clim": "vmin and vmax", "scalars": "values", "s": "radii", "radius": "radii", "point_size": "radii",
    "opacity": "material=glint.Material(transmission=0.5)", "alpha": "material=glint.Material(transmission=0.5)",
    "duration": "fps", "bg": "background", "viewup": "up",
}  # fmt: skip


_MISSING = {"add_mesh": "mesh(), which takes an object with vertices and faces"}


def attribute_hint(kind: str, name: str) -> str:
    """'; glint has position', or nothing."""
    known = _ATTRIBUTES.get(kind, {}).get(name)
    return f"; glint has {known}" if known else ""


def missing_hint(function: str) -> str:
    """The same of a function that was called with too few arguments."""
    known = _MISSING.get(function)
    return f"; glint has {known}" if known else ""


def keyword_hint(name: str, known: str) -> str:
    """The same of a keyword of a function; known: those that it has, in one text."""
    hint = _KEYWORDS.get(name)
    return f"; glint has {hint}" if hint and hint.replace("=", " ").split()[0] in known.split() else ""
