// SPDX-License-Identifier: Apache-2.0
#pragma once
// The explanation of a pixel: every ray that was traced for it, and every term of its light.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glint/export.h"
#include "glint/layers.h"
#include "glint/render.h"
#include "glint/result.h"
#include "glint/scene.h"

namespace glint {

/// The shape that blocks a light at a point; if there are several, the nearest to the point.
struct Blocker {
    std::uint32_t shape = k_none;  ///< in Scene::shapes
    double distance = 0;           ///< from the shaded point
    Vec3 point;
};

/// A transparent surface on the way of a shadow ray, which colors the light.
struct ShadowFilter {
    std::uint32_t shape = k_none;  ///< in Scene::shapes
    double distance = 0;           ///< from the shaded point
    Vec3 point;
    Color factor;  ///< transmit + filter * color; with Material::caustics, times 1 + |N.L|^caustics
    /// Where the way to the light leaves an object that fades it: what is left (Material::fade_distance).
    Color fade{1, 1, 1};
};

/// A sample of an area light that shines from its centre, with its shadow ray.
struct ShadowSample {
    std::int32_t sample = 0;  ///< row * samples_u + column
    /// Its factor in LightTerms::visible (and filter), which is the sum over the visible samples. The weights
    /// of all samples add up to 1; a sample between two regions of different fineness may count in both.
    double weight = 0;
    Vec3 position;
    bool blocked = false;
    Vec3 origin, direction;  ///< of the ray, as in LightTerms
    double t_min = 0, t_max = 0;
    std::optional<Blocker> blocker;
    Color filter{1, 1, 1};              ///< as in LightTerms, of this sample
    std::vector<ShadowFilter> filters;  ///< likewise
};

/// One light at one hit, or one sample of an area light. Vectors and cosines are those of the lighting
/// equation (docs/lighting.md).
struct LightTerms {
    std::uint32_t light = 0;   ///< in Scene::lights
    std::int32_t sample = -1;  ///< row * samples_u + column, if each sample is a light of its own; else -1
    Vec3 to_light;             ///< to the position of a light that has one; else its own direction. Not unit
    double distance = 0;       ///< its length
    double attenuation = 1;    ///< f_att
    double spot = 1;           ///< of a spot: the factor of its light in this direction
    double emitter = 1;        ///< of a one-sided area light: the cosine off its normal, 0 behind it
    /// Of an area light that shines from its centre: the visible part; if transparent surfaces color it, the
    /// mean over the channels of `filter`.
    double visible = 1;
    double n_l = 0;                 ///< N·L
    double s = 0;                   ///< R·V (Phong) or N·H (Blinn-Phong)
    double power = 0;               ///< S^n if there is a highlight, blocked or not; else 0
    double diffuse_factor = 0;      ///< of k_d I: N·L, to the power of the brilliance
    double phong_s = 0;             ///< R·V of the second highlight, if a material has one
    double phong_power = 0;         ///< of the second highlight, as `power`
    Color highlight_tint{1, 1, 1};  ///< of a metal's highlights; included in `specular`
    double threshold = 0;           ///< Conventions::light_threshold
    bool may_add = false;           ///< it adds light unless it is blocked
    bool blocked = false;           ///< a shape blocks it: `blocker`
    Color diffuse, specular;        ///< the light that it adds, before the hit's weight
    /// The product of the factors of `filters`, multiplied in the order of the ray; of an area light that
    /// shines from its centre, with colored shadows: the mean of its samples' light. Included in diffuse and,
    /// with Conventions::attenuate_highlights, in specular.
    Color filter{1, 1, 1};
    std::vector<ShadowFilter> filters;  ///< the transparent surfaces on the way to the light, from P
    bool has_ray = false;               ///< a shadow ray was traced, with the following values
    Vec3 origin, direction;             ///< for a point light: from the light to the surface
    double t_min = 0, t_max = 0;
    std::optional<Blocker> blocker;
    std::vector<ShadowSample> samples;  ///< of an area light that shines from its centre: those traced
};

/// The state of a possible secondary ray of a hit.
enum class SecondaryRayState : std::uint8_t {
    none,    ///< the surface is not a mirror, or neither glass nor transparent
    traced,  ///< `ray` is its index
    limit,   ///< the limit of reflections is reached
    faint,   ///< its weight is 0 or below min_weight
    cut,     ///< the sample already has k_max_sample_rays rays
};
/// The mirror ray or the glass ray of a hit.
struct ExplainedSecondaryRay {
    SecondaryRayState state = SecondaryRayState::none;
    Color weight;  ///< the factor of its light in the pixel; unknown at the limit
    int ray = -1;  ///< in Explanation::rays
};

/// The light from all directions at a hit (Occlusion).
struct ExplainedOcclusion {
    int samples = 0, blocked = 0;
    double factor = 1;       ///< f; if transparent surfaces color the light, the mean over the channels
    Color factors{1, 1, 1};  ///< f by channel
    Color light;             ///< k_d color f
    Color part;              ///< added to the pixel: `light` times weight, local_share and outline
    struct Occluder {
        std::uint32_t shape = k_none;  ///< in Scene::shapes
        int samples = 0;               ///< of which it is the nearest occluder
        /// What f loses by them: 1 / samples each, and with OcclusionMethod::fixed 2 N·d / samples for the
        /// direction d. Where no light is colored, f and these add up to the f of a surface without
        /// occluders.
        double weight = 0;
    };
    std::vector<Occluder> occluders;  ///< the shape with the most samples first
};

/// What a texture shows at a surface's point.
struct ExplainedTexture {
    std::uint32_t texture = k_none;  ///< in Scene::textures
    double u = 0, v = 0;             ///< of the surface, after Texture::uv_map
    /// The texels that are mixed: two columns, counted from the left from 0, and two rows, from the top. With
    /// TextureFilter::nearest, the second ones are the first; beside the picture, with TextureWrap::clip, all
    /// are -1. With a Texture::color_map, columns are its colors, from 0, and there is one row.
    int column = 0, next_column = 0, row = 0, next_row = 0;
    /// The first ones have 1 minus these. With TextureFilter::distance, where the point is between them.
    double next_column_weight = 0, next_row_weight = 0;
    Color color;  ///< decoded and mixed
    double alpha = 1;
    Color ambient, diffuse;  ///< color times Texture::ambient and diffuse; of layers, the sums of these
    bool is_layer = false;   ///< one of `layers`
    double weight = 1;       ///< of a layer: its opacity, times what is left of those in front
    /// With Texture::over: the layers from the front on. color and alpha are those of all of them: alpha is
    /// the sum of the weights, and alpha color that of weight times color. columns are -1 where the front one
    /// is not.
    std::vector<ExplainedTexture> layers{};
};

/// A place of a surface that a ray passes: a hole of its texture (TextureAlpha::mask), or the back of a
/// one-sided surface (Material::one_sided).
struct ExplainedHole {
    std::uint32_t shape = k_none;             ///< in Scene::shapes
    double t = 0;                             ///< of the ray
    bool back = false;                        ///< it is the back of a one-sided surface
    double cutoff = 0;                        ///< Texture::alpha_cutoff: the texture's alpha is below it
    std::optional<ExplainedTexture> texture;  ///< not set at the back
};
/// The holes of a ray that are listed.
inline constexpr std::size_t k_max_explained_holes = 16;

/// Where the line of a ray crosses a shape of the solid that it hits.
struct ExplainedCrossing {
    int operand = 0;       ///< the number of the solid's shape, from 0
    double t = 0;          ///< of the ray
    bool enters = false;   ///< the shape begins there; otherwise it ends
    bool surface = false;  ///< the solid has a surface there
    bool hit = false;      ///< it is the surface that the ray hits
};
/// The crossings of a hit that are listed.
inline constexpr std::size_t k_max_explained_crossings = 64;

struct ExplainedHit {
    std::uint32_t shape = k_none;     ///< in Scene::shapes
    std::uint32_t material = k_none;  ///< in Scene::materials; k_none: the default material
    std::uint32_t element = 0;        ///< the part of the shape: the triangle of a polygon or mesh, the
                                      ///< operand of a solid, from 0
    std::optional<Color> color;       ///< the shape's own color, in place of the material's
    std::optional<ExplainedTexture> texture;  ///< if the material has one that shows something here
    Vec3 point, normal, to_eye;               ///< N as used for shading, unit; V
    bool behind = false;                      ///< the ray came from the back of the shape
    bool turned = false;                      ///< N was flipped towards the ray
    Color weight;                             ///< the ray's weight after absorption in glass and in fog
    double mirror = 0;                        ///< a in the direction of the ray
    /// The factor of ambient and diffuse light and of emission; the rest is mirror and glass.
    double local_share = 1;
    Color ambient;                   ///< k_a I_a; for shading color or normals, the shown color
    std::vector<LightTerms> lights;  ///< in scene order, without ambient lights
    double outline = 1;              ///< the factor of the outline (Material::outline)
    Color diffuse, specular;         ///< sums over the lights; the diffuse one times `outline`
    Color emission;                  ///< k_e
    /// Added to the pixel: ambient, diffuse, specular and emission times weight and local_share.
    Color parts[4];
    bool transparent = false;  ///< Material::filter or transmit: `transmitted` goes straight through,
                               ///< or is refracted (Material::refracts)
    double opacity = 1;        ///< of a transparent surface, by the convention `opacity`
    /// Of a transparent surface: the factor of what is behind it, transmit + filter * color. With
    /// Material::angled_opacity, transmit is 1 - the opacity at this angle.
    Color through{1, 1, 1};
    Color fade{1, 1, 1};  ///< where light leaves an object: what is left of it (Material::fade_distance)
    double highlight_share = 1;  ///< the factor of the surface's highlights, as local_share of the rest
    double fresnel = 0;          ///< for glass: the reflected fraction; 1: total internal reflection, also of
                                 ///< transparent surfaces (Material::refracts)
    ExplainedSecondaryRay reflected, transmitted;
    int triangle = -1;  ///< of a mesh, from 0; -1: the shape has no mesh
    /// Of a mesh: the weights of the triangle's corners at P (its barycentric coordinates), by which normals
    /// and colors are interpolated; and P in the mesh's coordinates.
    Vec3 corner_weights, mesh_point;
    /// Of a solid: the crossings of the ray's line with all of its shapes, by t, before and behind the hit.
    /// Those within 1e-9 of each other (relative to the coordinates) are one event, at which a surface is
    /// that of one shape. Empty if there are more than k_max_explained_crossings.
    std::vector<ExplainedCrossing> crossings;
    std::optional<ExplainedOcclusion> occlusion;  ///< if the scene has occlusion, in a lit shading mode

    /// What the surface adds to the pixel: the parts, then that of the occlusion.
    Color own_light() const {
        const Color sum = parts[0] + parts[1] + parts[2] + parts[3];
        return occlusion ? sum + occlusion->part : sum;
    }
};

struct ExplainedRay {
    int sample = 0;            ///< row * n + column of the pixel's n x n samples
    int generation = 0;        ///< 0: camera ray
    int parent = -1;           ///< the ray whose hit it starts from
    bool transmitted = false;  ///< through glass or a transparent surface; otherwise reflected
    /// It goes straight through a transparent surface: its line is that of the ray before, from t_min on.
    bool straight = false;
    /// It starts at the limit of reflections, and sees the background (LimitRule::background).
    bool beyond_limit = false;
    Vec3 origin, direction;  ///< its length is the unit of t
    double t_min = 0;
    double t = 0;  ///< of the hit, or infinity
    Color weight;
    int hole_count = 0;                ///< the holes that it passes on its way to the hit
    std::vector<ExplainedHole> holes;  ///< the first of them, at most k_max_explained_holes
    std::optional<ExplainedHit> hit;
    Color background;  ///< the light that the ray adds to the pixel if it hits nothing
    /// It hits nothing and shows the background directly or through glass: the mean of its weight times
    /// 1 - Conventions::background_alpha is subtracted from alpha. With RenderSettings::alpha and a
    /// background_alpha of 0, `background` is then black.
    bool transparent = false;
    double visibility = 1;  ///< in fog: f, of the hit or of the background; included in the hit's weight
    /// With FogExtent::outside_objects: the ray is inside an object that is not hollow, so that it has no
    /// fog.
    bool inside_object = false;
    Color fog;  ///< the light that the fog adds to the pixel, after that of the hit or the background
};

/// With adaptive sampling: the neighbour from which the pixel differs most with one sample each.
struct SampleDifference {
    std::int32_t x = -1, y = -1;  ///< the neighbour; -1: the picture has one pixel
    double difference = 0;        ///< of the channel that differs most
    Color own, neighbor;          ///< the colors with one sample
};

/// All data of one pixel. Rays are in the order of summation: by sample, then by generation. The sum of a
/// layer (docs/explain.md) adds, ray by ray, the background or the parts of the hit, with that of its
/// occlusion, then the fog. `layers` are the sums divided by the number of samples and rounded to float;
/// `value` is the sum of the layers in their order.
struct Explanation {
    std::int32_t x = 0, y = 0;
    int samples = 1;  ///< n for n x n samples; with adaptive sampling, those that this pixel has
    std::optional<SampleDifference> adaptive;  ///< set if the scene has adaptive sampling
    std::vector<ExplainedRay> rays;
    float layers[k_light_layers][3] = {};
    float value[3] = {};  ///< linear, not clamped: the value in the picture
    float alpha = 1;      ///< the value in Layer::alpha
    RayCounts counts;
};

inline constexpr std::size_t k_max_explained_rays = 100000;

struct ExplainOptions {
    /// Only the rays of this sample (row * n + column) are stored; -1: the rays of all samples, if there are
    /// at most k_max_explained_rays. A pixel that adaptive sampling gives one sample has that one. Layers and
    /// value are always those of the pixel.
    int sample = -1;
    std::string isa = {};  ///< one of isa_names(); empty: the best
};

/// Renders pixel (x, y), counted from the top left, with the kernels of render(), and records what they
/// compute. The world must have been prepared from this scene: it is an error if the numbers of shapes or
/// materials, or the lights, differ. Never throws.
GLINT_API Result<Explanation> explain(const Scene& scene, const World& world, std::int32_t x, std::int32_t y,
                                      const ExplainOptions& options = {});

/// The reason why a light adds light or not at a hit.
enum class LightReason : std::uint8_t {
    adds,
    blocked,        ///< something is between it and the point
    behind,         ///< N·L <= 0, and there is no highlight
    no_color,       ///< its color times k_d is black, and there is no highlight
    faded,          ///< f_att is 0
    in_surface,     ///< the light is at the surface point, so it has no direction
    outside_cone,   ///< beyond the spot's outer angle
    faint,          ///< N·L f_att spot is not above Conventions::light_threshold
    back_of_light,  ///< the one-sided area light faces away
};
GLINT_API LightReason reason(const LightTerms& terms);

/// The reason why there is a highlight or not, regardless of blockers.
enum class HighlightReason : std::uint8_t {
    adds,
    none,         ///< k_s times the light's specular color is black
    unshaded,     ///< the shading has no highlights
    behind,       ///< N·L <= 0, which the convention specular_gate excludes
    turned_away,  ///< S <= 0: the reflected light points away from the eye
};
/// `none` if the scene has no light with that index.
GLINT_API HighlightReason highlight_reason(const LightTerms& terms, const ExplainedHit& hit,
                                           const Scene& scene);

/// The material of a hit: the scene's, or the default if the scene has no material with that index; with the
/// shape's own color, if it has one, and the color of the texture at the point.
GLINT_API Material material_of(const ExplainedHit& hit, const Scene& scene);

/// The names of these values in JSON and messages: "turned_away". "unknown" for invalid values.
GLINT_API std::string_view to_string(LightReason reason);
GLINT_API std::string_view to_string(HighlightReason reason);
GLINT_API std::string_view to_string(SecondaryRayState state);

/// The layer of a ray's light: that of the first secondary ray on its path. Nothing for camera rays, whose
/// parts have different layers, for an invalid index, and if the path does not lead to a camera ray.
GLINT_API std::optional<Layer> layer_of(const Explanation& explanation, std::size_t ray);

/// Draws the pixel's rays over the picture, which has the world's size: a white frame around the pixel,
/// mirror rays in blue, rays through glass in green, shadow rays of lights that add light in yellow, and
/// those of blocked lights in red up to the blocker and dark behind it. The rays of all samples are drawn. An
/// error, with an unchanged picture, if the picture has another size, or the explanation or the world does
/// not belong to this scene. Never throws.
GLINT_API Status render_overlay(Image& picture, const Explanation& explanation, const Scene& scene,
                                const World& world);

/// The value of each sample, row by row: linear, not rounded. Their mean is the pixel's value except for
/// rounding. The explanation must contain all samples. An error if its rays belong to samples that it does
/// not have. Never throws.
GLINT_API Result<std::vector<Color>> sample_values(const Explanation& explanation);

/// The explanation as JSON (docs/explain.md has its schema), with names and places from the scene. file: the
/// bits and transfer by which the numbers of a file are computed. An error if the explanation does not belong
/// to this scene, or the bits are not 8 or 16. Never throws.
GLINT_API Result<std::string> explanation_json(const Explanation& explanation, const Scene& scene,
                                               const EncodeOptions& file = {});

}  // namespace glint
