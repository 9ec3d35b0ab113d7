# SPDX-License-Identifier: Apache-2.0
"""glint: a deterministic Phong and Blinn-Phong ray tracer for learning and teaching.

    import glint

    scene = glint.load("castle.json")
    scene.lights[0].intensity *= 2
    scene.render(size=(640, 480)).save("castle.png")

docs/python.md is the guide.
"""

from ._animate import animate
from ._classes import complete_classes
from ._colors import ColorScale
from ._diagnosis import Diagnosis, ProposedPixel, diagnose, propose_pixels
from ._errors import GlintError, GlintWarning
from ._framing import add_methods
from ._glint import (
    BackgroundGradient,
    Box,
    Camera,
    CameraFrame,
    Cone,
    Cylinder,
    Diagnostic,
    Disc,
    Fog,
    Light,
    Material,
    Mesh,
    Occlusion,
    Plane,
    Polygon,
    Quadric,
    Quartic,
    Shape,
    SmoothTriangle,
    Solid,
    Sphere,
    Texture,
    Torus,
    Triangle,
    isa_names,
)
from ._glint import version as __version__
from ._grading import Graded, GradedPart, Grades, grade
from ._image import Image
from ._live import LiveView
from ._reports import Comparison, Explanation, Record
from ._scene import Hits, Scene
from ._settings import profiles, setting_infos
from ._show import show
from ._surface import Surface, surface
from ._tools import Finding, Versus, check, compare, convert, explain, load, loads, versus
from ._trace_log import TraceLog
from ._values import Attenuation, Color, ColorLike, Vec3, VectorLike

complete_classes()
add_methods()

__all__ = [
    "Attenuation", "BackgroundGradient", "Box", "Camera", "CameraFrame", "Color", "ColorLike", "ColorScale", "Comparison", "Cone", "Cylinder",
    "Diagnosis", "Diagnostic", "Disc", "Explanation", "Finding", "Fog", "GlintError", "GlintWarning", "Graded", "GradedPart", "Grades", "Hits",
    "Image", "Light", "LiveView", "Material", "Mesh", "Occlusion", "Plane", "Polygon", "ProposedPixel", "Quadric", "Quartic", "Record", "Scene", "Shape", "SmoothTriangle", "Solid", "Sphere",
    "Surface", "Texture", "Torus", "TraceLog", "Triangle", "Vec3", "VectorLike", "Versus", "animate", "check", "compare", "convert", "diagnose", "explain", "grade", "isa_names",
    "load", "loads", "profiles", "propose_pixels", "setting_infos", "show", "surface", "versus",
]
