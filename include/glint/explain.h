// SPDX-License-Identifier: Apache-2.0
#pragma once
// Why a pixel is as it is: every ray that was traced for it, and every term of its light.
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

/// What keeps a light from a point: of all that lies between them the nearest to the point.
struct Blocker {
    std::uint32_t shape = k_none;  ///< in Scene::shapes
    double distance = 0;           ///< from the point that is shaded
    Vec3 point;
};

/// One light at one hit. Vectors and cosines are those of the lighting equation (docs/lighting.md).
struct LightTerms {
    std::uint32_t light = 0;  ///< in Scene::lights
    Vec3 to_light;            ///< to a point light: the whole way; else as the light has it. Not unit
    double distance = 0;      ///< its length
    double attenuation = 1;   ///< f_att
    double n_l = 0;           ///< N·L
    double s = 0;             ///< R·V (Phong) or N·H (Blinn-Phong)
    double power = 0;         ///< S^n where there is a highlight, blocked or not; else 0
    bool may_add = false;     ///< it would add something if nothing were in the way
    bool blocked = false;     ///< something is: `blocker`
    Color diffuse, specular;  ///< what it adds, before the hit's weight
    bool has_ray = false;     ///< a shadow ray was traced, as follows
    Vec3 origin, direction;   ///< of a point light's: from the light to the surface
    double t_min = 0, t_max = 0;
    std::optional<Blocker> blocker;
};

/// What becomes of a ray that could leave a hit.
enum class BranchState : std::uint8_t {
    none,    ///< the surface is no mirror, or no glass
    traced,  ///< `ray` is it
    limit,   ///< the limit of reflections is reached
    faint,   ///< its weight is 0 or below min_weight
    cut,     ///< the sample has k_max_sample_rays already
};
struct Branch {
    BranchState state = BranchState::none;
    Color weight;  ///< what it finds counts for this much of the pixel; unknown at the limit
    int ray = -1;  ///< in Explanation::rays
};

struct ExplainedHit {
    std::uint32_t shape = k_none;     ///< in Scene::shapes
    std::uint32_t material = k_none;  ///< in Scene::materials; k_none: the default material
    Vec3 point, normal, to_eye;       ///< N as it was lit, unit; V
    bool behind = false;              ///< the ray came from behind the shape's own normal
    bool turned = false;              ///< and N was turned towards it
    Color weight;                     ///< the ray's, less what glass absorbed on the way
    double local_share = 1;           ///< of the surface's own light, beside mirror and glass
    Color ambient;                    ///< k_a I_a; with shading color or normals, what is shown
    std::vector<LightTerms> lights;   ///< in the order of the scene, without ambient ones
    Color diffuse, specular;          ///< the sums of the lights'
    Color parts[3];      ///< ambient, diffuse and specular times weight and share: what the pixel gets
    double fresnel = 0;  ///< of glass: what it reflects; 1: total internal reflection
    Branch reflected, transmitted;
};

struct ExplainedRay {
    int sample = 0;            ///< row n + column of the pixel's n x n samples
    int generation = 0;        ///< 0: the camera's
    int parent = -1;           ///< the ray whose hit let this one go
    bool transmitted = false;  ///< through glass; else mirrored
    Vec3 origin, direction;    ///< of the length that t is measured in
    double t_min = 0;
    double t = 0;  ///< of the hit, or infinity
    Color weight;
    std::optional<ExplainedHit> hit;
    Color background;  ///< what a ray that hits nothing adds to the pixel
};

/// Everything of one pixel. Rays are in the order of the pixel's sums: sample after sample, generation after
/// generation. Each sum takes, ray after ray, the background, or the parts of the hit, in the layer that
/// docs/explain.md says; divided by the samples and rounded to float it is `layers`, and these added up in
/// their order are `value`.
struct Explanation {
    std::int32_t x = 0, y = 0;
    int samples = 1;  ///< n of n x n
    std::vector<ExplainedRay> rays;
    float layers[k_light_layers][3] = {};
    float value[3] = {};  ///< linear, not clamped: the picture's own
    RayCounts counts;
};

inline constexpr std::size_t k_max_explained_rays = 100000;

struct ExplainOptions {
    /// The rays of this sample alone are written down, row n + column; -1: of all, if they are not more than
    /// k_max_explained_rays. Layers and value are always those of the pixel.
    int sample = -1;
    std::string isa = {};  ///< one of isa_names(); empty: the best
};

/// Draws pixel (x, y), counted from the top left, by render()'s own kernels and writes down what they do. The
/// world must be of this scene: it is an error if the scene has since got other numbers of shapes or
/// materials or other lights. Never throws.
GLINT_API Result<Explanation> explain(const Scene& scene, const World& world, std::int32_t x, std::int32_t y,
                                      const ExplainOptions& options = {});

/// Why a light adds something, or nothing, at a hit.
enum class LightReason : std::uint8_t {
    adds,
    blocked,     ///< something is between it and the point
    behind,      ///< N·L <= 0, and no highlight either
    no_color,    ///< its colour times k_d is black, and there is no highlight either
    faded,       ///< f_att is 0
    in_surface,  ///< the light is at the point itself: no direction leads to it
};
GLINT_API LightReason reason(const LightTerms& terms);

/// Why there is a highlight, or none, blocked lights aside.
enum class HighlightReason : std::uint8_t {
    adds,
    none,         ///< k_s times the light's specular colour is black
    unshaded,     ///< the shading has no highlights
    behind,       ///< N·L <= 0, and the convention specular_gate asks for more
    turned_away,  ///< S <= 0: the mirrored light goes away from the eye
};
/// `none` if the scene has no light of that number.
GLINT_API HighlightReason highlight_reason(const LightTerms& terms, const ExplainedHit& hit,
                                           const Scene& scene);

/// The material of a hit: of the scene, or the default if the scene has none of that number.
GLINT_API const Material& material_of(const ExplainedHit& hit, const Scene& scene);

/// The words of these, as JSON and messages have them: "turned_away". "unknown" for any other number.
GLINT_API std::string_view to_string(LightReason reason);
GLINT_API std::string_view to_string(HighlightReason reason);
GLINT_API std::string_view to_string(BranchState state);

/// The layer that a ray's light belongs to: that of its path's first branch. For camera rays: nothing, since
/// each of their parts has a layer of its own. Nothing either if there is no such ray, or its path does not
/// lead to a camera ray.
GLINT_API std::optional<Layer> layer_of(const Explanation& explanation, std::size_t ray);

/// Draws the pixel's rays over the picture (of the world's size): the camera ray's pixel with a white frame,
/// mirror rays blue, rays through glass green, the way to each light that adds something yellow, and to each
/// that is blocked red up to its blocker, dark from there. Every sample's rays are drawn. With an error
/// nothing is drawn: the picture has another size, or the explanation or the world are not of this scene.
/// Never throws.
GLINT_API Status draw_overlay(Image& picture, const Explanation& explanation, const Scene& scene,
                              const World& world);

/// The value of each sample, row after row: linear, not rounded; their mean is the pixel's value but for
/// roundings. The explanation must be of all samples. An error if its rays are not of samples that it has.
/// Never throws.
GLINT_API Result<std::vector<Color>> sample_values(const Explanation& explanation);

/// The explanation as JSON (docs/explain.md has its schema): names and places from the scene, the file's
/// numbers by its bits and transfer. An error if the explanation is not of this scene, or the bits are not 8
/// or 16. Never throws.
GLINT_API Result<std::string> explanation_json(const Explanation& explanation, const Scene& scene,
                                               const EncodeOptions& file = {});

}  // namespace glint
