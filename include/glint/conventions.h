// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the sources of this renderer disagree about, as data. docs/conventions.md says which source means
// what.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/diagnostic.h"
#include "glint/export.h"
#include "glint/result.h"

namespace glint {

enum class Shading : std::uint8_t { phong, blinn_phong, diffuse, color, normals };

/// Where in its pixel a camera ray passes. corner: the bottom-left corner (CGFS). whole: at whole pixel units
/// from the picture's middle (LIGHT).
enum class PixelSample : std::uint8_t { center, corner, whole };

/// Length of a camera ray's direction, which scales its t. viewport: as the viewport point gives it (CGFS).
enum class RayDirection : std::uint8_t { unit, viewport };

/// How a ray leaves a surface point P with normal N.
/// ray: origin P, t > epsilon. normal: origin P + epsilon N. facing: P + epsilon N turned to the incoming
/// ray's side. direction: P + epsilon along the unit outgoing ray. scale: as facing, by the outgoing ray's
/// side, with epsilon relative to the magnitude of P.
enum class Offset : std::uint8_t { ray, normal, facing, direction, scale };

/// mirror: blend: (1-a) local + a reflected; add: local + a reflected.
enum class MirrorRule : std::uint8_t { blend, add };

/// What the last permitted surface gives. keep: its local colour whole (CGFS, RT2). drop: as if the mirror
/// saw black.
enum class LimitRule : std::uint8_t { keep, drop };

/// What a mirror ray that leaves the scene sees.
enum class MissRule : std::uint8_t { background, black };

/// How much of the light that glass would let through it reflects instead. schlick: by the angle (CSC 473).
enum class Fresnel : std::uint8_t { none, schlick };

/// Whether a surface that lets light through casts a shadow. opaque: as any other (CSC 473); none: it does
/// not.
enum class GlassShadow : std::uint8_t { opaque, none };

/// Which normals are turned towards the incoming ray. open: of planes, discs, triangles, uncapped cylinders
/// and cones.
enum class Facing : std::uint8_t { none, open, all };

/// Every difference between the sources. The defaults are the profile `glint`.
struct Conventions {
    PixelSample pixel_sample = PixelSample::center;
    RayDirection ray_direction = RayDirection::unit;
    double camera_t_min = 0;    ///< camera rays hit only at t > this
    bool specular_gate = true;  ///< the highlight needs N·L > 0
    /// N·L and S below 0 add nothing. false: a classic fault, and LIGHT's own code.
    bool clamp_cosines = true;
    bool normalize = true;  ///< L, V, R, H are normalised; false: a classic fault
    Offset offset = Offset::scale;
    double epsilon = 1e-9;  ///< see Offset; 0: a classic fault (acne)
    /// Only what is between a point and a point light blocks it. false: a classic fault, what is beyond the
    /// light casts a shadow too.
    bool shadow_stops_at_light = true;
    MirrorRule mirror = MirrorRule::blend;
    LimitRule limit = LimitRule::keep;
    MissRule mirror_miss = MissRule::background;
    Fresnel fresnel = Fresnel::none;
    /// > 0: Beer's law in place of one tint where a ray enters: what a black tint absorbs per unit of length.
    double beer = 0;
    GlassShadow glass_shadow = GlassShadow::opaque;
    double min_weight = 0;  ///< a ray whose weight is below this is not traced
    Facing facing = Facing::all;
    bool cones = true;  ///< false: cones are left out, as CSC 473's own program does
    friend bool operator==(const Conventions&, const Conventions&) = default;
};

/// What a render is asked for, apart from the model. Profiles and files set it; the command line overrides.
struct RenderSettings {
    std::int32_t width = 640, height = 480;  ///< pixels, 1 to k_max_size
    Shading shading = Shading::blinn_phong;
    bool shadows = true;
    std::int32_t reflections = 4;  ///< most generations of mirror and glass rays, 0 to k_max_reflections
    std::int32_t samples = 1;      ///< n: n x n regular samples a pixel, 1 to k_max_samples
    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

inline constexpr std::int32_t k_max_size = 65536;
inline constexpr std::int32_t k_max_reflections = 1000;
inline constexpr std::int32_t k_max_samples = 64;

/// Mirror and glass rays of one sample of a pixel: those beyond are not traced. Only a surface that is both
/// can come near it, by doubling the rays at every generation.
inline constexpr std::int32_t k_max_sample_rays = 4096;

/// Conventions and settings together with where each value came from.
struct SettingOrigin {
    enum class Kind : std::uint8_t { profile, file, command, code };
    Kind kind = Kind::profile;
    SourcePlace place;  ///< for Kind::file
};

/// A key of Conventions or RenderSettings as text: what `--convention KEY=VALUE` and `conventions { }` take.
struct SettingKey {
    std::string_view name;         ///< "specular_gate"
    std::string_view values;       ///< "true | false", "a number >= 0", ...
    std::string_view description;  ///< one line
    bool is_convention;            ///< false: a render setting (size, shading, shadows, reflections, aa)
};

/// All keys, in a fixed order; the index is what SettingOrigins are stored by.
GLINT_API std::span<const SettingKey> setting_keys();

/// The index of a key, or nothing if there is no such key.
GLINT_API std::optional<std::size_t> find_setting(std::string_view name);

struct Scene;

/// Sets one key from text. An error if it cannot be: "expected true or false, found 'maybe'".
GLINT_API Status set_setting(Scene& scene, std::size_t key, std::string_view value, SettingOrigin origin);

/// The value of a key as the text that set_setting takes; empty if there is no such key.
GLINT_API std::string get_setting(const Scene& scene, std::size_t key);

/// cgfs, epfl, lecture5, light, csc473, nff, glint.
GLINT_API std::span<const std::string_view> profile_names();

/// Sets every key of the scene to the profile's value (origin: profile). An error if there is no such
/// profile.
GLINT_API Status apply_profile(Scene& scene, std::string_view profile);

}  // namespace glint
