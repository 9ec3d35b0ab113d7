// SPDX-License-Identifier: Apache-2.0
#pragma once
// The Scene: shapes, materials, lights, camera, settings. Plain data; make it in code or load it from text.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "glint/conventions.h"
#include "glint/diagnostic.h"
#include "glint/export.h"
#include "glint/item_names.h"
#include "glint/mesh.h"
#include "glint/shapes.h"
#include "glint/solid.h"
#include "glint/texture.h"
#include "glint/vec.h"

namespace glint {

enum class Projection : std::uint8_t { perspective, orthographic };
enum class FovAxis : std::uint8_t { x, y };

/// An explicit camera frame: `right` spans the picture's whole width and `up` its whole height at `forward`
/// from the position, for any aspect ratio (CGFS: the viewport; CSC 473: right and up as written).
/// Any handedness.
struct CameraFrame {
    Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};
    friend bool operator==(const CameraFrame&, const CameraFrame&) = default;
};

/// The camera. Without a frame it is right-handed: x = normalize(forward × up),
/// y = x × forward; pixels are square.
struct Camera {
    Projection projection = Projection::perspective;
    Vec3 position{0, 0, 0};
    Vec3 look_at{0, 0, -1};
    Vec3 up{0, 1, 0};
    double fov_degrees = 60;  ///< perspective: full angle along fov_axis, 0 < fov < 180
    FovAxis fov_axis = FovAxis::x;
    double width = 2;                  ///< orthographic: the picture's width in world units
    std::optional<CameraFrame> frame;  ///< if set, replaces look_at, up, fov and width
    std::optional<Vec3> lighting_eye;  ///< V points here instead of along -D (LIGHT)

    // The fields that are used.
    constexpr bool has_target() const { return !frame; }  ///< look_at and up
    constexpr bool has_fov() const { return !frame && projection == Projection::perspective; }
    constexpr bool has_width() const { return !frame && projection == Projection::orthographic; }
};

/// A new kind comes last (docs/adding_a_light.md).
enum class LightKind : std::uint8_t { ambient, point, directional, spot, parallelogram, disc, sphere };
inline constexpr int k_light_kinds = 7;

/// The maximum of an area light's samples_u and samples_v.
inline constexpr std::int32_t k_max_light_samples = 64;
/// A value of Light::adaptive with which every sample is traced.
inline constexpr std::int32_t k_all_levels = 16;

struct Attenuation {
    /// f_att = 1 / (c0 + c1 d + c2 d^2), at most 1 (LIGHT-12; see Conventions::clamp_attenuation); d:
    /// distance.
    double c0 = 1, c1 = 0, c2 = 0;
    friend bool operator==(const Attenuation&, const Attenuation&) = default;
};

struct Light {
    LightKind kind = LightKind::point;
    Vec3 position{};                ///< point lights and spots; the centre of area lights
    Vec3 to_light{0, 1, 0};         ///< directional lights: towards the light, any length except 0
    Color color{1, 1, 1};           ///< I_a of an ambient light, else I_l,d: intensity included
    Color specular_color{1, 1, 1};  ///< I_l,s; ambient lights have none
    Attenuation attenuation{};      ///< lights with a position
    /// Lights with a position: if both are above 0, f_att also has the factor 2 / (1 + (d / fade_distance) ^
    /// fade_power), d the distance (POV-Ray).
    double fade_distance = 0, fade_power = 0;
    /// Spots and `cone`: the middle of the cone, away from the light. Discs: their normal, towards what they
    /// light. Any length except 0.
    Vec3 axis{0, -1, 0};
    double inner_angle = 30;    ///< spots: degrees off the axis, 0 to outer_angle; within it, the full light
    double outer_angle = 45;    ///< spots: degrees off the axis, 0 < outer_angle <= 180; beyond it, no light
    double tightness = 0;       ///< spots: exponent of the cosine off the axis (SpotFalloff::cubic), >= 0
    bool casts_shadows = true;  ///< false: nothing blocks the light; not for ambient lights

    // Area lights: parallelograms, discs and spheres (Conventions::area_shading).
    Vec3 side_u{1, 0, 0}, side_v{0, 0, 1};  ///< parallelograms: whole sides, not parallel
    double radius = 1;                      ///< discs and spheres, > 0
    /// The columns and rows of samples, 1 to k_max_light_samples: along side_u and side_v; of discs and
    /// spheres: rings, and samples in each ring.
    std::int32_t samples_u = 4, samples_v = 4;
    /// Parallelograms and discs: only the side of side_u × side_v or `axis` gives light, times the cosine of
    /// the angle off that normal. false: both sides give light, the same in all directions.
    bool one_sided = false;
    bool jitter = false;  ///< the samples are moved within their cells, differently at each surface point
    /// With AreaShading::center: regions of the grid below this level of subdivision are always divided,
    /// others only if neighbouring corners differ (POV-Ray); 0 to k_all_levels.
    std::int32_t adaptive = k_all_levels;
    /// Parallelograms: the grid of samples is bent to the ellipse in the parallelogram (POV-Ray).
    bool circular = false;
    /// Parallelograms: each surface point sees a square that faces it, whose sides have the length of side_u;
    /// the first is at right angles to the z axis (POV-Ray).
    bool oriented = false;
    /// Parallelograms: the light has the cone of a spot, around `axis`; one_sided has no effect (POV-Ray).
    bool cone = false;

    // The properties of the kind; other code calls these functions. The compiler warns if a switch lacks a
    // kind.

    /// Adds k_a I_a to every surface: it has no direction and casts no shadow.
    constexpr bool is_ambient() const {
        switch (kind) {
            case LightKind::ambient:
                return true;
            case LightKind::point:
            case LightKind::spot:
            case LightKind::directional:
            case LightKind::parallelogram:
            case LightKind::disc:
            case LightKind::sphere:
                return false;
        }
        return false;
    }
    /// Has a `position`, at a finite distance. Other lights are infinitely far away.
    constexpr bool has_position() const {
        switch (kind) {
            case LightKind::point:
            case LightKind::spot:
            case LightKind::parallelogram:
            case LightKind::disc:
            case LightKind::sphere:
                return true;
            case LightKind::ambient:
            case LightKind::directional:
                return false;
        }
        return false;
    }
    /// Has the direction `to_light` from every point.
    constexpr bool has_direction() const {
        switch (kind) {
            case LightKind::directional:
                return true;
            case LightKind::ambient:
            case LightKind::point:
            case LightKind::spot:
            case LightKind::parallelogram:
            case LightKind::disc:
            case LightKind::sphere:
                return false;
        }
        return false;
    }
    /// Lights only a cone around `axis`.
    constexpr bool is_spot() const { return kind == LightKind::spot || (is_parallelogram() && cone); }
    constexpr bool is_parallelogram() const { return kind == LightKind::parallelogram; }
    constexpr bool is_disc() const { return kind == LightKind::disc; }
    constexpr bool is_sphere() const { return kind == LightKind::sphere; }
    /// Has an extent and is represented by samples.
    constexpr bool is_area() const { return is_parallelogram() || is_disc() || is_sphere(); }
    /// Whether the places of its samples differ from surface point to surface point.
    constexpr bool moves_samples() const { return is_area() && (jitter || (is_parallelogram() && oriented)); }
    constexpr bool has_radius() const { return is_disc() || is_sphere(); }
    constexpr bool has_axis() const { return is_spot() || is_disc(); }
    /// Has two sides.
    constexpr bool is_flat() const { return is_parallelogram() || is_disc(); }
    constexpr bool may_be_one_sided() const { return is_flat() && !is_spot(); }
    /// Whether its light decreases with the cosine off its normal.
    constexpr bool has_emitter_cosine() const { return may_be_one_sided() && one_sided; }
    constexpr bool has_specular_color() const { return !is_ambient(); }
    constexpr bool has_attenuation() const { return has_position(); }
    /// Whether f_att has POV-Ray's factor.
    constexpr bool fades() const { return has_attenuation() && fade_distance > 0 && fade_power > 0; }
    /// Whether f_att may be below 1. Otherwise it is exactly 1 at any distance (with clamp_attenuation).
    constexpr bool falls_off() const {
        return has_attenuation() &&
               (attenuation.c0 > 1 || attenuation.c1 != 0 || attenuation.c2 != 0 || fades());
    }
    /// The vector from a point to the light's position, or the direction `to_light`; any length. Not for
    /// ambient lights.
    constexpr Vec3 way_from(Vec3 point) const { return has_position() ? position - point : to_light; }
};

enum class FogKind : std::uint8_t { linear, exp, exp2 };

/// Fog, and depth cueing: of the light that comes from distance d, the part f is seen, and 1 - f of the fog's
/// color is added. linear: f = (end - d) / (end - start); exp: exp(-density (d - start)); exp2:
/// exp(-(density (d - start))^2); at least `transmit` and 0, at most 1. The conventions fog_distance,
/// fog_background and fog_extent say what d is, whether the background is in the fog, and whether the insides
/// of objects are. (POV-Ray, Tachyon; measured)
///
/// exp with falloff > 0 is fog on the ground: density (d - start) is the integral, from `start` to d along
/// the ray, of density / (1 + z^2), where z = (y - height) / falloff, at least 0, and y is the coordinate
/// along `up`. (POV-Ray's fog_type 2; measured)
struct Fog {
    FogKind kind = FogKind::exp;
    Color color{0.5, 0.5, 0.5};
    double density = 0.1;  ///< exp, exp2: per world unit
    double start = 0;      ///< in world units
    double end = 100;      ///< linear: above start
    double transmit = 0;   ///< the least f, 0 to 1
    /// What is seen through the fog, where f is below 1, has the factor 1 - filter + filter color; 0 to 1
    /// (POV-Ray).
    double filter = 0;
    double falloff = 0;  ///< exp; above 0: the density halves from `height` to this much above; world units
    double height = 0;   ///< exp with a falloff: below it the fog has its whole density; world units
    Vec3 up{0, 1, 0};    ///< exp with a falloff: away from the ground; any length but 0

    // The fields that are used.
    constexpr bool has_density() const { return kind != FogKind::linear; }
    constexpr bool has_falloff() const { return kind == FogKind::exp; }
    constexpr bool is_on_ground() const { return has_falloff() && falloff > 0; }
    constexpr bool has_end() const { return kind == FogKind::linear; }
    friend bool operator==(const Fog&, const Fog&) = default;
};

/// How the directions of occlusion samples are chosen. hashed: by the hash of pixel, sample and path, in
/// proportion to the cosine. fixed: one sequence for all pixels, evenly over the hemisphere (Tachyon).
enum class OcclusionMethod : std::uint8_t { hashed, fixed };

inline constexpr std::int32_t k_max_occlusion_samples = 4096;

/// Light that comes from all directions and that shapes block (ambient occlusion; Tachyon's Sky_Light). A
/// surface reflects k_d color f. f is the part of the light that arrives, by samples in the hemisphere of N:
/// hashed: the fraction of the samples that are not blocked; fixed: 2/samples times the sum of N·D over the
/// directions D that are not blocked, which may exceed 1 (Tachyon, measured).
struct Occlusion {
    OcclusionMethod method = OcclusionMethod::hashed;
    std::int32_t samples = 64;  ///< for each surface point, 1 to k_max_occlusion_samples
    Color color{1, 1, 1};       ///< of the light
    /// Shapes farther away do not block; in world units, above 0.
    double reach = __builtin_huge_val();
    double direct = 1;  ///< factor of the light of all lights but the ambient ones, 0 to 1e6

    friend bool operator==(const Occlusion&, const Occlusion&) = default;
};

/// What a background gradient depends on. sphere: the direction of the ray (Tachyon's Sky_Sphere, POV-Ray's
/// sky_sphere). plane: the origin of the ray, for orthographic cameras (Tachyon's Sky_Ortho_Plane).
enum class GradientKind : std::uint8_t { sphere, plane };

/// A background that changes along `up`: bottom_color where the coordinate x along `up`, of the ray's unit
/// direction or of its origin, is `bottom`, top_color where it is `top`, linear between and constant beyond.
struct BackgroundGradient {
    GradientKind kind = GradientKind::sphere;
    Vec3 up{0, 1, 0};  ///< any length but 0
    double bottom = 0, top = 1;
    Color bottom_color{1, 1, 1}, top_color{0.2, 0.4, 0.8};
    /// Beyond `bottom` and `top` the colors repeat (POV-Ray's sky_sphere with `gradient`).
    bool repeats = false;
    /// In place of the two colors, 1 to k_max_texture_colors in the order of `at`, from 0 at `bottom` to 1 at
    /// `top`; linear between them, constant before the first and after the last. Each alpha is 1.
    std::vector<TextureColor> color_map{};

    friend bool operator==(const BackgroundGradient&, const BackgroundGradient&) = default;
};

/// The greatest Material::interior.
inline constexpr std::int32_t k_max_interior = 1'000'000'000;

struct Material {
    Color color{0.8, 0.8, 0.8};       ///< the color in shading mode `color`
    Color ambient{0.08, 0.08, 0.08};  ///< k_a
    Color diffuse{0.64, 0.64, 0.64};  ///< k_d
    Color specular{0, 0, 0};          ///< k_s
    double shininess = 32;            ///< the specular exponent n, >= 0
    double mirror = 0;                ///< a, 0 to 1
    Color mirror_tint{1, 1, 1};
    double transmission = 0;  ///< f (CSC 473's filter) or T (NFF), 0 to 1
    double ior = 1;           ///< index of refraction, > 0
    Color transmission_tint{1, 1, 1};
    bool casts_shadow = true;  ///< false: a surface with this material blocks no light

    // A World stores the following fields only if one of them differs from its default.

    Color emission{0, 0, 0};  ///< k_e: light that the surface emits by itself; it lights no other surface
    double brilliance = 1;    ///< the diffuse term is k_d (N·L)^brilliance, >= 0 (POV-Ray)
    /// 0 to 1: highlights have the tint 1 + metallic (1 - F) (color - 1); F rises from 0 to 1 with the angle
    /// of the light (POV-Ray).
    double metallic = 0;
    Color phong{0, 0, 0};          ///< k_p: a second highlight, k_p (R·V)^phong_shininess in either shading
    double phong_shininess = 40;   ///< its exponent, >= 0
    bool tinted_highlight = true;  ///< false: highlights do not have the light's color (Tachyon's Metal)
    /// > 0: a depends on the angle. It is mirror_min + (mirror - mirror_min) (1 - cos)^mirror_falloff, with
    /// the cosine of the ray and the normal (POV-Ray). 0: it is `mirror`.
    double mirror_falloff = 0;
    double mirror_min = 0;  ///< a for rays along the normal, 0 to 1
    double mirror_metallic =
        0;  ///< 0 to 1: what the mirror shows has the tint of `metallic`, by the ray's angle

    /// Instead of `transmit`, rays see through the surface by 1 - (1 + cos(pi transmit c))^2 / 4, with the
    /// cosine c of ray and normal (Raster3D, Tachyon). Shadows have `transmit`.
    bool angled_opacity = false;

    // Transparency without refraction: what is behind is seen times transmit + filter * color (POV-Ray).
    double filter = 0;    ///< 0 to 1; with `transmit` at most 1; only if `transmission` is 0
    double transmit = 0;  ///< 0 to 1: not tinted; Tachyon's 1 - opacity
    bool hollow = false;  ///< for FogExtent::outside_objects: rays inside are in the fog (POV-Ray)

    // An outline, as in drawings (Tachyon): diffuse light and that from all directions are multiplied by
    // 1 - outline + outline (1 - (1 - c^2)^(32 (1 - outline_width))), with the cosine c of ray and normal.
    double outline = 0;        ///< 0 to 1: how dark it is
    double outline_width = 0;  ///< 0 to 1: all of the surface; only if outline > 0

    /// For FogExtent::outside_objects. 0: each shape is an object. Else the shapes of all materials with this
    /// number are one object, as the triangles of a mesh; at most k_max_interior.
    std::int32_t interior = 0;

    /// Into Scene::textures; k_none: none.
    std::uint32_t texture = k_none;

    /// Rays pass the surface where they come from behind, against its normal; it blocks light on both sides
    /// (glTF's doubleSided = false). No effect if `transmission` > 0: refracted rays have to leave.
    bool one_sided = false;

    /// Rays that a transparent surface lets through are refracted by `ior`, into and out of a closed shape.
    /// Where no light gets through (total reflection), the mirror ray has it.
    bool refracts = false;

    /// a depends on the angle by Fresnel's equations: mirror_min + (mirror - mirror_min) F, with F of
    /// unpolarized light between `ior` and what is around the shape; mirror_falloff has no effect (POV-Ray).
    bool mirror_fresnel = false;

    /// What `filter` and `transmit` let through to the eye is multiplied by 1 - a mirror_tint (POV-Ray).
    /// Shadows do not change.
    bool conserve_energy = false;

    /// > 0: light that leaves the shape through its transparent surface has the factor
    /// 1 - (1 - fade_color) (1 - T) with T = 1 / (1 + (d / fade_distance)^fade_power), and from a power of
    /// 1000 on exp(-(1 - fade_color) d / fade_distance). d is the distance from the last surface, in world
    /// units (POV-Ray).
    double fade_distance = 0;
    double fade_power = 1;      ///< >= 0
    Color fade_color{0, 0, 0};  ///< what is left of white light after a long way

    /// > 0: the light of a shadow ray that `filter` and `transmit` let through is also multiplied by
    /// 1 + |N.L|^caustics, at each surface: brighter where it comes along the normal (POV-Ray: 45 times its
    /// `caustics`). Without effect on light from all directions.
    double caustics = 0;

    constexpr bool is_transparent() const { return filter > 0 || transmit > 0; }
    /// Whether a depends on the angle.
    constexpr bool has_angled_mirror() const { return mirror_falloff > 0 || mirror_fresnel; }
};

/// A shape's own color, in single precision; NaN: none. See Scene::shape_colors.
struct ShapeColor {
    static constexpr float k_unset = __builtin_nanf("");
    float r = k_unset, g = k_unset, b = k_unset;

    constexpr bool is_set() const { return r == r || g == g || b == b; }
    constexpr Color color() const { return {r, g, b}; }
};

/// Names and places of a list of items, by index. Empty for scenes made in code; names are sparse.
struct ItemTexts {
    ItemNames names;
    std::vector<SourcePlace> places;

    /// The item's name, or an empty string.
    std::string_view name(std::uint32_t index) const;
    /// The item's place, or one with line 0.
    SourcePlace place(std::uint32_t index) const;
};

/// Which normals the scene's source requires to be unit vectors. Glint normalises all.
struct UnitNormals {
    bool of_planes = false, of_vertices = false;
    std::string_view reason;  ///< the effect of another length in the source, as part of a sentence
    /// The lengths of the camera's right, up and forward if its rotation is one; none: the source allows any.
    std::optional<Vec3> frame_lengths;
};

struct Scene {
    Camera camera;
    Color background{0, 0, 0};
    std::optional<BackgroundGradient> gradient;  ///< if set, in place of `background`
    std::optional<Fog> fog;                      ///< not in the shading modes color and normals
    std::optional<Occlusion> occlusion;          ///< not in the shading modes color and normals
    std::vector<Light> lights;
    std::vector<Material> materials;
    std::vector<Affine> transforms;                       ///< world_from_object, invertible
    std::vector<Vec3> polygon_vertices;                   ///< referred to by Polygons
    std::vector<std::shared_ptr<const MeshData>> meshes;  ///< referred to by Meshes; shared by copies
    std::vector<SolidTree> solids;                        ///< referred to by Solids
    std::vector<Texture> textures;                        ///< referred to by materials
    /// By mesh: the index in `files` of the file that it was read from, which has no other mesh; k_no_file:
    /// none. A shorter list: the other meshes are of no file.
    std::vector<std::uint16_t> mesh_files;
    static constexpr std::uint16_t k_no_file = 0xffff;
    std::vector<Shape> shapes;  ///< in scene order: of two shapes hit at the same t, the first counts
    /// By shape; a shorter list leaves the other shapes without a color of their own. A shape with one looks
    /// as if it had with_color(its material, its color), in 12 bytes instead of a material.
    std::vector<ShapeColor> shape_colors;

    Conventions conventions;
    RenderSettings settings;

    UnitNormals unit_normals;                   ///< set by the format's reader, regardless of the conventions
    std::vector<std::uint32_t> base_materials;  ///< those that the source made others of, in order
    std::string profile = "glint";
    std::vector<SettingOrigin> origins;  ///< by setting key; may be empty (all from the profile)
    std::vector<std::string> files;      ///< the names of the texts it was read from
    ItemTexts light_texts, material_texts, texture_texts, shape_texts;
    SourcePlace camera_place, background_place, fog_place, gradient_place, occlusion_place;

    /// The parameters of all shapes of one kind, e.g. get<Sphere>().
    template <class T> std::vector<T>& get() { return std::get<std::vector<T>>(parameters); }
    template <class T> const std::vector<T>& get() const { return std::get<std::vector<T>>(parameters); }

    /// The shape's own color, if it has one.
    std::optional<Color> shape_color(std::uint32_t shape) const {
        if (shape >= shape_colors.size() || !shape_colors[shape].is_set()) return std::nullopt;
        return shape_colors[shape].color();
    }
    /// Sets it, rounded to single precision. Throws only std::bad_alloc.
    void set_shape_color(std::uint32_t shape, const std::optional<Color>& color);

    /// Adds a shape and returns its index in `shapes`. Throws only std::bad_alloc.
    template <class T>
    std::uint32_t add(const T& shape, std::uint32_t material = k_none, std::uint32_t transform = k_none);

    // std::tuple of one vector per kind, from the list of kinds; the int ends the list.
    std::tuple<
#define GLINT_KIND(Type, word) std::vector<Type>,
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
            int>
        parameters;
};

template <class T> struct ShapeKindOf;
#define GLINT_KIND(Type, word) \
    template <> struct ShapeKindOf<Type> { static constexpr ShapeKind value = ShapeKind::word; };
GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND

inline void Scene::set_shape_color(std::uint32_t shape, const std::optional<Color>& color) {
    if (!color && shape >= shape_colors.size()) return;
    if (shape >= shape_colors.size()) shape_colors.resize(std::size_t{shape} + 1);
    shape_colors[shape] = color ? ShapeColor{static_cast<float>(color->r), static_cast<float>(color->g),
                                             static_cast<float>(color->b)}
                                : ShapeColor{};
}

template <class T> std::uint32_t Scene::add(const T& shape, std::uint32_t material, std::uint32_t transform) {
    auto& list = get<T>();
    list.push_back(shape);
    shapes.push_back(
        {ShapeKindOf<T>::value, static_cast<std::uint32_t>(list.size() - 1), material, transform});
    return static_cast<std::uint32_t>(shapes.size() - 1);
}

/// The shapes that a solid consists of; nothing for other kinds.
inline std::span<const Shape> operands_of(const Scene& scene, const Shape& shape) {
    if (shape.kind != ShapeKind::solid || shape.index >= scene.get<Solid>().size()) return {};
    const std::uint32_t solid = scene.get<Solid>()[shape.index].solid;
    if (solid >= scene.solids.size()) return {};
    return scene.solids[solid].operands;
}

/// A solid of shapes, in order; those that are solids become parts of the tree. The parts need not be in
/// Scene::shapes. Adds the transforms that it composes to the scene. validate() tells of parts that enclose
/// no space. Throws only std::bad_alloc.
GLINT_API SolidTree combine(Scene& scene, SolidOperation operation, std::span<const Shape> parts);

/// Replaces the scene's shapes from index `first` on by a solid of them, and returns its index; k_none
/// without any. Their colors are lost; Scene::shape_texts is not changed. Throws only std::bad_alloc.
GLINT_API std::uint32_t combine_last(Scene& scene, SolidOperation operation, std::uint32_t first,
                                     std::uint32_t material = k_none, std::uint32_t transform = k_none);

/// The material with another color. Its ambient, diffuse and specular coefficients stay the same multiples
/// of the color, if they are multiples of it; of a black color, black coefficients become the usual
/// multiples (0.1, 0.8 and 0).
GLINT_API Material with_color(const Material& material, Color color);

/// The word of a kind in scene files and messages: "sphere", "point".
GLINT_API std::string_view to_string(ShapeKind kind);
GLINT_API std::string_view to_string(LightKind kind);
GLINT_API std::string_view to_string(FogKind kind);
GLINT_API std::string_view to_string(OcclusionMethod method);
GLINT_API std::string_view to_string(GradientKind kind);
GLINT_API std::string_view to_string(TextureWrap wrap);
GLINT_API std::string_view to_string(TextureFilter filter);
GLINT_API std::string_view to_string(TextureMix mix);
GLINT_API std::string_view to_string(TextureEncoding encoding);
GLINT_API std::string_view to_string(TextureAlpha alpha);
GLINT_API std::string_view to_string(TextureMapping mapping);

/// Checks every number and index of the scene; prepare() needs a scene without errors. Warnings report
/// likely mistakes (no lights: the picture will be black). Messages have the item's place if it is
/// known.
GLINT_API std::vector<Diagnostic> validate(const Scene& scene);

}  // namespace glint
