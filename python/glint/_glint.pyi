# SPDX-License-Identifier: Apache-2.0
# Types of the extension module. The fields of lights, materials and cameras are those of src/scene/*_fields.h;
# a test compares this file with the module.
from typing import Any, Callable, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._scene import Scene
from ._values import Attenuation, Color, ColorLike, Vec3, VectorLike
from ._words import (
    FogKind,
    FovAxis,
    GradientKind,
    LightKind,
    OcclusionMethod,
    Projection,
    Severity,
    SolidOperation,
    TextureAlpha,
    TextureEncoding,
    TextureFilter,
    TextureMapping,
    TextureMix,
    TextureWrap,
)

version: str
_Report = Optional[Callable[[float], object]]
_Settings = Sequence[Tuple[str, str]]

# Attributes that take more than they give: any three numbers, and give a Vec3 or a Color.
class _VectorField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Vec3: ...
    def __set__(self, owner: object, value: VectorLike) -> None: ...

class _ColorField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Color: ...
    def __set__(self, owner: object, value: ColorLike) -> None: ...

class _AttenuationField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Attenuation: ...
    def __set__(self, owner: object, value: VectorLike) -> None: ...

class _OptionalVectorField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Optional[Vec3]: ...
    def __set__(self, owner: object, value: Optional[VectorLike]) -> None: ...

class _ShapeColorField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Optional[Color]: ...
    def __set__(self, owner: object, value: Optional[ColorLike]) -> None: ...

class _PointsField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> npt.NDArray[np.float64]: ...
    def __set__(self, owner: object, value: Any) -> None: ...

class _PartsField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Tuple[Any, ...]: ...
    def __set__(self, owner: object, value: Iterable[Shape]) -> None: ...

class _MatrixField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Optional[npt.NDArray[np.float64]]: ...
    def __set__(self, owner: object, value: Any) -> None: ...

class _AffineField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> npt.NDArray[np.float64]: ...
    def __set__(self, owner: object, value: Any) -> None: ...

class _UvMapField:
    def __get__(
        self, owner: object, kind: Optional[type] = ...
    ) -> Tuple[Tuple[float, float, float], Tuple[float, float, float]]: ...
    def __set__(self, owner: object, value: Any) -> None: ...

class _ImageField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> npt.NDArray[Any]: ...
    def __set__(self, owner: object, value: Any) -> None: ...

class _ColorMapField:
    def __get__(self, owner: object, kind: Optional[type] = ...) -> Optional[List[Tuple[Any, ...]]]: ...
    def __set__(self, owner: object, value: Any) -> None: ...

class Diagnostic:
    @property
    def severity(self) -> Severity: ...
    @property
    def file(self) -> str: ...
    @property
    def line(self) -> int: ...
    @property
    def column(self) -> int: ...
    @property
    def message(self) -> str: ...
    @property
    def item(self) -> str: ...
    @property
    def can_skip(self) -> bool: ...
    def __getstate__(self) -> Tuple[Any, ...]: ...
    def __setstate__(self, state: Tuple[Any, ...]) -> None: ...

class Light:
    def __init__(
        self,
        kind: LightKind = ...,
        *,
        name: str = ...,
        intensity: float = ...,
        color: ColorLike = ...,
        specular_color: ColorLike = ...,
        position: VectorLike = ...,
        to_light: VectorLike = ...,
        axis: VectorLike = ...,
        inner_angle: float = ...,
        outer_angle: float = ...,
        tightness: float = ...,
        attenuation: VectorLike = ...,
        fade_distance: float = ...,
        fade_power: float = ...,
        side_u: VectorLike = ...,
        side_v: VectorLike = ...,
        radius: float = ...,
        samples_u: int = ...,
        samples_v: int = ...,
        one_sided: bool = ...,
        jitter: bool = ...,
        adaptive: int = ...,
        circular: bool = ...,
        oriented: bool = ...,
        cone: bool = ...,
        casts_shadows: bool = ...,
    ) -> None: ...
    name: str
    kind: LightKind
    intensity: float
    color: _ColorField
    specular_color: _ColorField
    position: _VectorField
    to_light: _VectorField
    axis: _VectorField
    inner_angle: float
    outer_angle: float
    tightness: float
    attenuation: _AttenuationField
    fade_distance: float
    fade_power: float
    side_u: _VectorField
    side_v: _VectorField
    radius: float
    samples_u: int
    samples_v: int
    one_sided: bool
    jitter: bool
    adaptive: int
    circular: bool
    oriented: bool
    cone: bool
    casts_shadows: bool
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Light: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Light: ...
    __hash__: None  # type: ignore[assignment]

class Texture:
    def __init__(
        self,
        image: Any = ...,
        color_map: Any = ...,
        *,
        name: str = ...,
        mapping: TextureMapping = ...,
        from_uv: bool = ...,
        wrap_u: TextureWrap = ...,
        wrap_v: TextureWrap = ...,
        filter: TextureFilter = ...,
        mix: TextureMix = ...,
        encoding: TextureEncoding = ...,
        alpha: TextureAlpha = ...,
        alpha_cutoff: float = ...,
        mortar: VectorLike = ...,
        turbulence: VectorLike = ...,
        octaves: float = ...,
        gain: float = ...,
        lacunarity: float = ...,
        iterations: float = ...,
        uv_map: Any = ...,
        over: Optional[Texture] = ...,
        ambient: float = ...,
        diffuse: float = ...,
        world_from_texture: Any = ...,
    ) -> None: ...
    name: str
    file: str
    image: _ImageField
    color_map: _ColorMapField
    mapping: TextureMapping
    from_uv: bool
    wrap_u: TextureWrap
    wrap_v: TextureWrap
    filter: TextureFilter
    mix: TextureMix
    encoding: TextureEncoding
    alpha: TextureAlpha
    alpha_cutoff: float
    mortar: _VectorField
    turbulence: _VectorField
    octaves: float
    gain: float
    lacunarity: float
    iterations: float
    uv_map: _UvMapField
    over: Optional[Texture]
    ambient: float
    diffuse: float
    world_from_texture: _AffineField
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Texture: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Texture: ...
    __hash__: None  # type: ignore[assignment]

class Material:
    def __init__(
        self,
        *,
        name: str = ...,
        color: ColorLike = ...,
        ambient: ColorLike = ...,
        diffuse: ColorLike = ...,
        specular: ColorLike = ...,
        shininess: float = ...,
        mirror: float = ...,
        mirror_tint: ColorLike = ...,
        transmission: float = ...,
        transmission_tint: ColorLike = ...,
        casts_shadow: bool = ...,
        ior: float = ...,
        emission: ColorLike = ...,
        brilliance: float = ...,
        metallic: float = ...,
        phong: ColorLike = ...,
        phong_shininess: float = ...,
        tinted_highlight: bool = ...,
        mirror_falloff: float = ...,
        mirror_min: float = ...,
        mirror_fresnel: bool = ...,
        conserve_energy: bool = ...,
        mirror_metallic: float = ...,
        filter: float = ...,
        transmit: float = ...,
        outline: float = ...,
        outline_width: float = ...,
        angled_opacity: bool = ...,
        hollow: bool = ...,
        interior: int = ...,
        texture: Optional[Texture] = ...,
        one_sided: bool = ...,
        refracts: bool = ...,
        fade_distance: float = ...,
        fade_power: float = ...,
        fade_color: ColorLike = ...,
        caustics: float = ...,
    ) -> None: ...
    name: str
    color: _ColorField
    ambient: _ColorField
    diffuse: _ColorField
    specular: _ColorField
    shininess: float
    mirror: float
    mirror_tint: _ColorField
    transmission: float
    transmission_tint: _ColorField
    casts_shadow: bool
    ior: float
    emission: _ColorField
    brilliance: float
    metallic: float
    phong: _ColorField
    phong_shininess: float
    tinted_highlight: bool
    mirror_falloff: float
    mirror_min: float
    mirror_fresnel: bool
    conserve_energy: bool
    mirror_metallic: float
    filter: float
    transmit: float
    outline: float
    outline_width: float
    angled_opacity: bool
    hollow: bool
    interior: int
    texture: Optional[Texture]
    one_sided: bool
    refracts: bool
    fade_distance: float
    fade_power: float
    fade_color: _ColorField
    caustics: float
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Material: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Material: ...
    __hash__: None  # type: ignore[assignment]

class CameraFrame:
    def __init__(self, *, right: VectorLike = ..., up: VectorLike = ..., forward: VectorLike = ...) -> None: ...
    right: _VectorField
    up: _VectorField
    forward: _VectorField
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> CameraFrame: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> CameraFrame: ...
    __hash__: None  # type: ignore[assignment]

class Camera:
    def __init__(
        self,
        *,
        position: VectorLike = ...,
        look_at: VectorLike = ...,
        up: VectorLike = ...,
        fov: float = ...,
        width: float = ...,
        lighting_eye: Optional[VectorLike] = ...,
        projection: Projection = ...,
        fov_axis: FovAxis = ...,
        frame: Optional[CameraFrame] = ...,
    ) -> None: ...
    position: _VectorField
    look_at: _VectorField
    up: _VectorField
    fov: float
    width: float
    lighting_eye: _OptionalVectorField
    projection: Projection
    fov_axis: FovAxis
    frame: Optional[CameraFrame]
    def fit(
        self,
        scene: Union[Scene, Tuple[VectorLike, VectorLike]],
        direction: Union[str, VectorLike] = ...,
        margin: float = ...,
        *,
        up: Optional[VectorLike] = ...,
        size: Optional[Tuple[int, int]] = ...,
    ) -> Camera: ...
    def orbit(self, right: float = ..., up: float = ...) -> Camera: ...
    def zoom(self, factor: float) -> Camera: ...
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Camera: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Camera: ...
    __hash__: None  # type: ignore[assignment]

class Occlusion:
    def __init__(
        self,
        method: OcclusionMethod = ...,
        *,
        samples: int = ...,
        color: ColorLike = ...,
        reach: float = ...,
        direct: float = ...,
    ) -> None: ...
    method: OcclusionMethod
    samples: int
    color: _ColorField
    reach: float
    direct: float
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Occlusion: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Occlusion: ...
    __hash__: None  # type: ignore[assignment]

class BackgroundGradient:
    def __init__(
        self,
        kind: GradientKind = ...,
        *,
        up: VectorLike = ...,
        bottom: float = ...,
        top: float = ...,
        bottom_color: ColorLike = ...,
        top_color: ColorLike = ...,
        repeats: bool = ...,
        color_map: Any = ...,
    ) -> None: ...
    kind: GradientKind
    up: _VectorField
    bottom: float
    top: float
    bottom_color: _ColorField
    top_color: _ColorField
    repeats: bool
    color_map: _ColorMapField
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> BackgroundGradient: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> BackgroundGradient: ...
    __hash__: None  # type: ignore[assignment]

class Fog:
    def __init__(
        self,
        kind: FogKind = ...,
        *,
        color: ColorLike = ...,
        density: float = ...,
        start: float = ...,
        end: float = ...,
        transmit: float = ...,
        filter: float = ...,
        falloff: float = ...,
        height: float = ...,
        up: VectorLike = ...,
    ) -> None: ...
    kind: FogKind
    color: _ColorField
    density: float
    start: float
    end: float
    transmit: float
    filter: float
    falloff: float
    height: float
    up: _VectorField
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Fog: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Fog: ...
    __hash__: None  # type: ignore[assignment]

class Shape:
    material: Optional[Material]
    color: _ShapeColorField
    transform: _MatrixField
    name: str
    @property
    def kind(self) -> str: ...
    def __sub__(self, other: Shape) -> Solid: ...
    def __and__(self, other: Shape) -> Solid: ...
    def __or__(self, other: Shape) -> Solid: ...
    def __invert__(self) -> Solid: ...
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Shape: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Shape: ...
    __hash__: None  # type: ignore[assignment]

class Sphere(Shape):
    def __init__(
        self,
        center: VectorLike = ...,
        radius: float = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    center: _VectorField
    radius: float

class Plane(Shape):
    def __init__(
        self,
        point: VectorLike = ...,
        normal: VectorLike = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    point: _VectorField
    normal: _VectorField

class Cylinder(Shape):
    def __init__(
        self,
        from_: VectorLike = ...,
        to: VectorLike = ...,
        radius: float = ...,
        caps: bool = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    from_: _VectorField
    to: _VectorField
    radius: float
    caps: bool

class Cone(Shape):
    def __init__(
        self,
        from_: VectorLike = ...,
        to: VectorLike = ...,
        from_radius: float = ...,
        to_radius: float = ...,
        caps: bool = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    from_: _VectorField
    to: _VectorField
    from_radius: float
    to_radius: float
    caps: bool

class Disc(Shape):
    def __init__(
        self,
        center: VectorLike = ...,
        normal: VectorLike = ...,
        radius: float = ...,
        hole: float = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    center: _VectorField
    normal: _VectorField
    radius: float
    hole: float

class Torus(Shape):
    def __init__(
        self,
        center: VectorLike = ...,
        axis: VectorLike = ...,
        radius: float = ...,
        tube: float = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    center: _VectorField
    axis: _VectorField
    radius: float
    tube: float

class Quadric(Shape):
    def __init__(
        self,
        squares: VectorLike = ...,
        products: VectorLike = ...,
        linear: VectorLike = ...,
        constant: float = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    squares: _VectorField
    products: _VectorField
    linear: _VectorField
    constant: float

class Quartic(Shape):
    def __init__(
        self,
        x4: float = ...,
        x3y: float = ...,
        x3z: float = ...,
        x3: float = ...,
        x2y2: float = ...,
        x2yz: float = ...,
        x2y: float = ...,
        x2z2: float = ...,
        x2z: float = ...,
        x2: float = ...,
        xy3: float = ...,
        xy2z: float = ...,
        xy2: float = ...,
        xyz2: float = ...,
        xyz: float = ...,
        xy: float = ...,
        xz3: float = ...,
        xz2: float = ...,
        xz: float = ...,
        x: float = ...,
        y4: float = ...,
        y3z: float = ...,
        y3: float = ...,
        y2z2: float = ...,
        y2z: float = ...,
        y2: float = ...,
        yz3: float = ...,
        yz2: float = ...,
        yz: float = ...,
        y: float = ...,
        z4: float = ...,
        z3: float = ...,
        z2: float = ...,
        z: float = ...,
        constant: float = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    x4: float
    x3y: float
    x3z: float
    x3: float
    x2y2: float
    x2yz: float
    x2y: float
    x2z2: float
    x2z: float
    x2: float
    xy3: float
    xy2z: float
    xy2: float
    xyz2: float
    xyz: float
    xy: float
    xz3: float
    xz2: float
    xz: float
    x: float
    y4: float
    y3z: float
    y3: float
    y2z2: float
    y2z: float
    y2: float
    yz3: float
    yz2: float
    yz: float
    y: float
    z4: float
    z3: float
    z2: float
    z: float
    constant: float

class Box(Shape):
    def __init__(
        self,
        min: VectorLike = ...,
        max: VectorLike = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    min: _VectorField
    max: _VectorField

class Triangle(Shape):
    def __init__(
        self,
        vertices: Any = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    vertices: _PointsField

class SmoothTriangle(Shape):
    def __init__(
        self,
        vertices: Any = ...,
        normals: Any = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    vertices: _PointsField
    normals: _PointsField

class Polygon(Shape):
    def __init__(
        self,
        vertices: Any,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    vertices: _PointsField

class Solid(Shape):
    def __init__(
        self,
        operation: SolidOperation,
        parts: Iterable[Shape],
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    operation: SolidOperation
    parts: _PartsField

class Mesh(Shape):
    def __init__(
        self,
        vertices: Any,
        triangles: Any,
        normals: Any = ...,
        colors: Any = ...,
        texture_coordinates: Any = ...,
        *,
        material: Optional[Material] = ...,
        color: Optional[ColorLike] = ...,
        transform: Any = ...,
        name: str = ...,
    ) -> None: ...
    @property
    def vertices(self) -> npt.NDArray[Any]: ...
    @property
    def triangles(self) -> npt.NDArray[np.uint32]: ...
    @property
    def normals(self) -> Optional[npt.NDArray[np.float32]]: ...
    @property
    def colors(self) -> Optional[npt.NDArray[np.float32]]: ...
    @property
    def texture_coordinates(self) -> Optional[npt.NDArray[np.float32]]: ...

class Rendering:
    def __init__(self, array: npt.NDArray[np.float32]) -> None: ...
    @staticmethod
    def decode(data: bytes, max_memory: int) -> Rendering: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def isa(self) -> str: ...
    @property
    def threads(self) -> int: ...
    @property
    def rays(self) -> Dict[str, int]: ...
    def array(self) -> npt.NDArray[np.float32]: ...
    def layer_names(self) -> List[str]: ...
    def layer(self, name: str) -> npt.NDArray[np.float32]: ...
    def viewable(self, name: str) -> Rendering: ...
    def copy(self) -> Rendering: ...
    def encode(self, format: str, bits: int, transfer: Optional[str]) -> bytes: ...

class SceneState:
    def __init__(self) -> None: ...
    def light_count(self) -> int: ...
    def light(self, index: int) -> Light: ...
    def light_named(self, name: str) -> Light: ...
    def set_lights(self, lights: List[Light]) -> None: ...
    def add_light(self, light: Light) -> int: ...
    def material_count(self) -> int: ...
    def material(self, index: int) -> Material: ...
    def material_named(self, name: str) -> Material: ...
    def set_material(self, index: int, material: Material) -> None: ...
    def add_material(self, material: Material) -> int: ...
    def texture_count(self) -> int: ...
    def texture(self, index: int) -> Texture: ...
    def texture_named(self, name: str) -> Texture: ...
    def add_texture(self, texture: Texture) -> int: ...
    def shape_count(self) -> int: ...
    def shape(self, index: int) -> Shape: ...
    def shape_named(self, name: str) -> Shape: ...
    def set_shape(self, index: int, shape: Shape) -> None: ...
    def remove_shapes(self, shapes: List[int]) -> None: ...
    def add_shape(self, shape: Shape) -> int: ...
    def get_setting(self, key: str) -> str: ...
    def set_setting(self, key: str, value: str) -> None: ...
    def apply_profile(self, name: str) -> None: ...
    @property
    def profile(self) -> str: ...
    @property
    def files(self) -> List[str]: ...
    background: _ColorField
    camera: Camera
    fog: Optional[Fog]
    gradient: Optional[BackgroundGradient]
    occlusion: Optional[Occlusion]
    def add_spheres(self, centers: Any, radii: Any, colors: Any, material: Optional[Material]) -> range: ...
    def add_cylinders(
        self, from_: Any, to: Any, radii: Any, colors: Any, material: Optional[Material], caps: bool
    ) -> range: ...
    def add_triangles(
        self, vertices: Any, faces: Any, normals: Any, colors: Any, material: Optional[Material]
    ) -> range: ...
    def shape_parameters(self, numbers: npt.NDArray[np.int64], name: str) -> npt.NDArray[np.float64]: ...
    def set_shape_parameters(self, numbers: npt.NDArray[np.int64], name: str, value: Any) -> None: ...
    def shape_colors(self, numbers: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]: ...
    def set_shape_colors(self, numbers: npt.NDArray[np.int64], value: Any) -> None: ...
    def shape_transforms(self, numbers: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]: ...
    def set_shape_transforms(self, numbers: npt.NDArray[np.int64], value: Any) -> None: ...
    def shape_materials(self, numbers: npt.NDArray[np.int64]) -> List[Optional[Material]]: ...
    def set_shape_materials(self, numbers: npt.NDArray[np.int64], materials: List[Optional[Material]]) -> None: ...
    def removals(self) -> int: ...
    def cast_rays(
        self, origins: Any, directions: Any, t_min: float, t_max: float, progress: _Report
    ) -> Tuple[
        npt.NDArray[np.float64], npt.NDArray[np.int64], npt.NDArray[np.float64], npt.NDArray[np.float64]
    ]: ...
    def bounds(self) -> Optional[Tuple[Vec3, Vec3]]: ...
    def load_texts(
        self,
        texts: Sequence[Tuple[str, bytes, str]],
        scene_name: str,
        profile: str,
        profile_text: Optional[Tuple[str, bytes]],
        settings: _Settings,
        max_memory: int,
        folders: Sequence[str],
        includes: str,
        skip_unsupported: bool,
        view: str,
        progress: _Report,
    ) -> None: ...
    def render(
        self,
        settings: _Settings,
        layers: List[str],
        crop: Optional[Tuple[int, int, int, int]],
        threads: int,
        isa: str,
        progress: _Report,
    ) -> Rendering: ...
    def explain(
        self, x: int, y: int, settings: _Settings, sample: Optional[int], fold: float, progress: _Report
    ) -> Tuple[str, str]: ...
    def check(self, progress: _Report) -> List[Tuple[str, Diagnostic, str, str]]: ...
    def diagnose(
        self, name: str, log: bytes, settings: _Settings, max_rows: int, threads: int, progress: _Report
    ) -> Diagnosed: ...
    def propose_pixels(
        self, picture: Rendering, settings: _Settings, threads: int
    ) -> List[Tuple[int, int, str, float]]: ...
    def write_glint(self) -> str: ...
    def write_scene(self, format: str) -> bytes: ...
    def write_whole_glint(self) -> str: ...
    def validate(self) -> List[Diagnostic]: ...
    def equals(self, other: SceneState) -> bool: ...
    def copy_from(self, other: SceneState) -> None: ...

class Diagnosed:
    def json(self) -> str: ...
    def text(self) -> str: ...
    def tree(self, x: int, y: int) -> str: ...

def has_values(object: Any) -> bool: ...
def isa_names() -> List[str]: ...
def formats() -> List[Tuple[str, str, str]]: ...
def written_formats() -> List[Tuple[str, str, str]]: ...
def check_kinds() -> Dict[str, str]: ...
def setting_keys() -> List[Tuple[str, str, str, bool]]: ...
def profile_names() -> List[str]: ...
def layer_infos() -> List[Tuple[str, str, str]]: ...
def compare(
    a: Rendering,
    b: Rendering,
    name_a: str,
    name_b: str,
    scene: Optional[SceneState],
    causes: bool,
    as_floats: bool,
    within: float,
    max_memory: int,
    progress: _Report,
) -> Tuple[str, str]: ...
def difference(a: Rendering, b: Rendering, gain: float) -> Rendering: ...
def find_causes(
    pictures: List[Rendering], reference: Rendering, scene: Optional[SceneState], progress: _Report
) -> List[Optional[Tuple[str, str, float]]]: ...
def grade_by_rubric(
    scene: SceneState,
    rubric: str,
    text: bytes,
    names: List[str],
    find: Callable[[int, str], Tuple[str, str, Optional[Rendering]]],
    progress: _Report,
) -> Tuple[
    List[Tuple[str, float]],
    List[
        Tuple[
            List[Tuple[float, str, Optional[str], str, float, Tuple[str, ...]]], Tuple[Tuple[str, float], ...]
        ]
    ],
]: ...
def submission_folders(folder: str) -> List[Tuple[str, str, str]]: ...
def is_match(name: str, pattern: str) -> bool: ...
