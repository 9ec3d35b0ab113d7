// SPDX-License-Identifier: Apache-2.0
#pragma once
// The rules on which this renderer's sources disagree, as data. docs/conventions.md lists the rules of each
// source.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/bytes.h"
#include "glint/diagnostic.h"
#include "glint/export.h"
#include "glint/result.h"

namespace glint {

enum class Shading : std::uint8_t { phong, blinn_phong, diffuse, color, normals };

/// The point of its pixel that a camera ray passes. corner: the bottom-left corner (CGFS). whole: whole pixel
/// units from the picture's middle (LIGHT). top_right: the top-right corner (Tachyon).
enum class PixelSample : std::uint8_t { center, corner, whole, top_right };

/// The length of a camera ray's direction, which scales its t. viewport: not normalised (CGFS).
enum class RayDirection : std::uint8_t { unit, viewport };

/// The origin of a ray that starts at a surface point P with normal N.
/// ray: origin P, t > epsilon. normal: origin P + epsilon N. facing: P + epsilon N, with N flipped to the
/// incoming ray's side. direction: P + epsilon along the unit outgoing ray. scale: like facing, on the
/// outgoing ray's side, with epsilon relative to the magnitude of P.
enum class Offset : std::uint8_t { ray, normal, facing, direction, scale };

/// mirror: blend: (1-a) local + a reflected; add: local + a reflected.
enum class MirrorRule : std::uint8_t { blend, add };

/// The color of a surface at the limit of reflections. keep: its whole local color, as if it were neither
/// mirror nor transparent (CGFS, RT2). drop: as if the mirror reflected black (POV-Ray). background: what
/// a ray that hits nothing sees is added for each secondary ray, without its coefficient (Tachyon).
enum class LimitRule : std::uint8_t { keep, drop, background };

/// The color of a mirror ray that hits nothing.
enum class MissRule : std::uint8_t { background, black };

/// The part of glass's transmitted light that is reflected instead. schlick: depends on the angle (CSC 473).
enum class Fresnel : std::uint8_t { none, schlick };

/// Whether a transparent surface casts a shadow. opaque: like any other surface (CSC 473); none: no
/// shadow.
enum class GlassShadow : std::uint8_t { opaque, none };

/// How transparency (Material::filter, transmit) reduces a surface's own light. highlights: ambient and
/// diffuse light times the opacity, highlights whole (POV-Ray). blend: all of it and the mirror ray's, too
/// (Tachyon's Trans_VMD). add: none of it (Tachyon).
enum class Transparency : std::uint8_t { highlights, blend, add };

/// The opacity of a transparent surface. whole: 1 - filter - transmit (POV-Ray from 3.7 on). brightest: 1 -
/// transmit - filter times the greatest channel of the color (POV-Ray before).
enum class OpacityRule : std::uint8_t { whole, brightest };

/// The shadows of transparent surfaces. opaque: as of any other surface. none: no shadow (Tachyon's
/// Shadow_Filter_Off). colored: each surface on the way multiplies the light by transmit + filter * color.
enum class TransparentShadow : std::uint8_t { opaque, none, colored };

/// Which normals are flipped towards the incoming ray. open: those of planes, discs, triangles, uncapped
/// cylinders and cones. winding: all, but the normal of a smooth triangle is flipped where the ray sees its
/// vertices clockwise, whatever the side of the normal (Tachyon).
enum class Facing : std::uint8_t { none, open, all, winding };

/// How the light of a spot decreases with the angle off its axis. cubic: by s^2 (3 - 2 s), s the position of
/// the angle's cosine between those of the outer and inner angle, times the cosine to the power `tightness`
/// (POV-Ray). linear: linearly in the angle (Tachyon); no tightness.
enum class SpotFalloff : std::uint8_t { cubic, linear };

/// The distance that fog depends on. ray: along the ray (POV-Ray, Tachyon). depth: of camera rays, along the
/// view; of others, along the ray (Tachyon's Fog_VMD).
enum class FogDistance : std::uint8_t { ray, depth };

/// Where the fog is. outside_objects: not along rays that are inside an object. A ray knows the objects that
/// it is inside: one through a surface enters or leaves the surface's object (POV-Ray). An object is a shape,
/// or the shapes whose materials have the same Material::interior; those with Material::hollow do not count.
enum class FogExtent : std::uint8_t { everywhere, outside_objects };

/// How an area light is represented by its samples. samples: each is a light of its own, with an equal part
/// of the color, at the centre of its cell. center: the light shines from its centre, and only its shadow is
/// sampled, at points that include the edges, whose weights come from repeated division into quarters
/// (POV-Ray).
enum class AreaShading : std::uint8_t { samples, center };

/// All rules on which the sources disagree. The defaults are the profile `glint`.
struct Conventions {
    PixelSample pixel_sample = PixelSample::center;
    RayDirection ray_direction = RayDirection::unit;
    double camera_t_min = 0;    ///< camera rays hit only at t > this
    bool specular_gate = true;  ///< the highlight needs N·L > 0
    /// N·L and S below 0 add nothing. false: a classic fault, and the code of LIGHT.
    bool clamp_cosines = true;
    bool normalize = true;  ///< L, V, R, H are normalised; false: a classic fault
    Offset offset = Offset::scale;
    double epsilon = 1e-9;  ///< see Offset; 0: a classic fault (acne)
    /// Only shapes between a point and a point light block the light. false: a classic fault; shapes beyond
    /// the light cast shadows, too.
    bool shadow_stops_at_light = true;
    MirrorRule mirror = MirrorRule::blend;
    LimitRule limit = LimitRule::keep;
    MissRule mirror_miss = MissRule::background;
    Fresnel fresnel = Fresnel::none;
    /// > 0: Beer's law instead of one tint at entry; the absorption of a black tint per unit of length.
    double beer = 0;
    GlassShadow glass_shadow = GlassShadow::opaque;
    Transparency transparency = Transparency::highlights;
    OpacityRule opacity = OpacityRule::whole;
    TransparentShadow transparent_shadow = TransparentShadow::colored;
    /// A ray straight through a transparent surface is of the next generation (Tachyon); false: of the same
    /// (POV-Ray). None starts at the limit of reflections.
    bool transparency_counts = false;
    /// Along one path, only this many transparent surfaces are shaded (0 to k_max_sample_rays); further ones
    /// are passed as if they were absent (Tachyon's Trans_Max_Surfaces).
    std::int32_t transparent_surfaces = 4096;
    /// Surfaces within this distance behind a transparent surface are not met by a ray that goes straight
    /// through it (POV-Ray: 0.0001).
    double transparent_epsilon = 0;
    /// The same for the light of shadow rays, and also near the point that is lit (POV-Ray: 0.001).
    double transparent_shadow_epsilon = 0;
    double min_weight = 0;  ///< a ray whose weight is below this is not traced
    Facing facing = Facing::all;
    bool cones = true;  ///< false: cones are ignored, as in CSC 473's own program
    SpotFalloff spot_falloff = SpotFalloff::cubic;
    /// 1 / (c0 + c1 d + c2 d^2) is at most 1 (LIGHT-12); false: it may exceed 1 near the light (Tachyon).
    bool clamp_attenuation = true;
    /// The attenuation and the factor of a spot apply to highlights; false: to the diffuse term only
    /// (Tachyon).
    bool attenuate_highlights = true;
    /// A light adds something only where N·L f_att spot is above this (Tachyon: 0.001959); 0: no such rule.
    double light_threshold = 0;
    AreaShading area_shading = AreaShading::samples;
    FogDistance fog_distance = FogDistance::ray;
    bool fog_background = true;  ///< the background is in the fog, at an infinite distance
    FogExtent fog_extent = FogExtent::everywhere;
    /// The alpha of the background in a picture with alpha, 0 to 1. 0: the background is left out. Above 0:
    /// it adds its color as it is, which has to be multiplied by this alpha (POV-Ray 3.7: 1 minus transmit).
    double background_alpha = 0;
    // How the picture's numbers become those of a PNG or PPM file (ByteRule); OpenEXR is always linear.
    Transfer transfer = Transfer::none;
    double gamma = 1;  ///< > 0, at most 100
    Rounding rounding = Rounding::half_even;
    constexpr ByteRule byte_rule() const { return {transfer, gamma, rounding}; }
    friend bool operator==(const Conventions&, const Conventions&) = default;
};

/// Settings that are not part of the model. Profiles and files set them; the command line overrides them.
struct RenderSettings {
    std::int32_t width = 640, height = 480;  ///< pixels, 1 to k_max_size
    Shading shading = Shading::blinn_phong;
    bool shadows = true;
    std::int32_t reflections = 4;  ///< maximum generations of mirror and glass rays, 0 to k_max_reflections
    std::int32_t samples = 1;      ///< n: n x n samples per pixel, 1 to k_max_samples
    /// If set, only pixels whose color with one sample differs by more than this, in any channel, from that
    /// of a neighbour left, right, above or below have n x n samples; the others have one. 0 to 1e6.
    std::optional<double> aa_threshold = {};
    /// The background, where it is seen directly or through glass, is left out: pixels have its share as
    /// alpha (Layer::alpha), and their light is multiplied by it.
    bool alpha = false;
    /// Each of n x n samples, n > 1, is at a place in its square that a hash of the pixel, the sample and the
    /// seed gives; false: at the same place in every square.
    bool jitter = false;
    std::uint32_t seed = 0;  ///< of everything that is sampled
    constexpr bool is_adaptive() const { return samples > 1 && aa_threshold.has_value(); }
    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

inline constexpr std::int32_t k_max_size = 65536;
inline constexpr std::int32_t k_max_reflections = 1000;
inline constexpr std::int32_t k_max_samples = 64;
/// The threshold of `aa = adaptive:N` without one.
inline constexpr double k_default_aa_threshold = 0.05;

/// The maximum number of mirror and glass rays, and of rays through transparent surfaces, of one sample; more
/// are not traced. Only surfaces that are both mirror and glass come near it, because they double the rays in
/// every generation, and thousands of transparent surfaces behind each other.
inline constexpr std::int32_t k_max_sample_rays = 4096;

/// The origin of the value of a convention or setting.
struct SettingOrigin {
    enum class Kind : std::uint8_t { profile, file, command, code };
    Kind kind = Kind::profile;
    SourcePlace place;  ///< for Kind::file
};

/// A key of Conventions or RenderSettings in text form, as in `--convention KEY=VALUE` and `conventions { }`.
struct SettingKey {
    std::string_view name;         ///< "specular_gate"
    std::string_view values;       ///< "true | false", "a number >= 0", ...
    std::string_view description;  ///< one line
    bool is_convention;  ///< false: a render setting (size, shading, shadows, reflections, aa, alpha,
                         ///< seed)
};

/// All keys, in a fixed order; the index is also that of SettingOrigins.
GLINT_API std::span<const SettingKey> setting_keys();

/// The index of a key, or nothing if there is no such key.
GLINT_API std::optional<std::size_t> find_setting(std::string_view name);

struct Scene;

/// Sets one key from text. An error for invalid text: "expected true or false, found 'maybe'".
GLINT_API Status set_setting(Scene& scene, std::size_t key, std::string_view value, SettingOrigin origin);

/// The value of a key, as text for set_setting(); empty if there is no such key.
GLINT_API std::string get_setting(const Scene& scene, std::size_t key);

/// The names of the profiles. docs/conventions.md says what each of them is for.
GLINT_API std::span<const std::string_view> profile_names();

/// Sets every key of the scene to the profile's value (origin: profile). An error if there is no such
/// profile.
GLINT_API Status apply_profile(Scene& scene, std::string_view profile);

}  // namespace glint
