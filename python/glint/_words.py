# SPDX-License-Identifier: Apache-2.0
"""The words that arguments take, for type checkers. A test compares them with the library's."""

from __future__ import annotations

from typing import Literal

Shading = Literal["phong", "blinn-phong", "diffuse", "color", "normals"]
PictureFormat = Literal["png", "ppm", "tga", "bmp", "jpeg", "exr"]
FilmFormat = Literal["gif", "apng", "mp4"]
Transfer = Literal["none", "srgb"]
SceneFormat = Literal["glb", "gltf", "glint"]
LightKind = Literal["ambient", "point", "directional", "spot", "parallelogram", "disc", "sphere"]
FogKind = Literal["linear", "exp", "exp2"]
Projection = Literal["perspective", "orthographic"]
FovAxis = Literal["x", "y"]
OcclusionMethod = Literal["hashed", "fixed"]
GradientKind = Literal["sphere", "plane"]
TextureMapping = Literal[
    "uv", "planar", "spherical", "cylindrical", "checker", "onion", "rings", "boxes", "slabs", "leopard", "bricks", "hexagons", "noise", "granite", "wrinkles", "spiral", "mandelbrot"
]  # fmt: skip
TextureWrap = Literal["repeat", "mirror", "clamp", "once", "clip"]
TextureFilter = Literal["nearest", "bilinear", "distance"]
TextureMix = Literal["multiply", "replace", "multiply_all"]
TextureEncoding = Literal["srgb", "linear"]
TextureAlpha = Literal["blend", "mask", "ignore"]
Severity = Literal["note", "warning", "error"]
SolidOperation = Literal["merge", "union", "intersection", "difference", "inverse", "clip"]
