// SPDX-License-Identifier: Apache-2.0
// The conventions of each source, as data. docs/conventions.md has the same table, with reasons.
#include <array>

#include "base/status.h"
#include "base/text.h"
#include "scene/settings.h"

namespace glint {
namespace {

constexpr Profile k_profiles[] = {
    {"cgfs",
     {.pixel_sample = PixelSample::corner,
      .ray_direction = RayDirection::viewport,
      .camera_t_min = 1,
      .specular_gate = false,
      .offset = Offset::ray,
      .epsilon = 0.001,
      .facing = Facing::none},
     {.width = 600, .height = 600, .shading = Shading::phong, .reflections = 3},
     Handedness::left},
    {"epfl",
     {.offset = Offset::normal, .epsilon = 0.001, .mirror_miss = MissRule::black, .facing = Facing::open},
     {.width = 640, .height = 640}},
    {"lecture5",
     {.offset = Offset::direction, .epsilon = 0.001, .facing = Facing::none},
     {.shading = Shading::phong}},
    {"light",
     {.pixel_sample = PixelSample::whole, .facing = Facing::none},
     {.width = 43, .height = 43, .shading = Shading::phong, .shadows = false, .reflections = 0}},
    {"csc473",
     {.specular_gate = false,
      .offset = Offset::facing,
      .epsilon = 0.001,
      .limit = LimitRule::drop,
      .facing = Facing::none,
      .cones = false},
     {.reflections = 6},
     Handedness::right_unless_povray},
    {"povray",
     {.offset = Offset::direction,
      .epsilon = 0.0001,
      .mirror = MirrorRule::add,
      .limit = LimitRule::drop,
      .transparent_epsilon = 0.0001,
      .transparent_shadow_epsilon = 0.001,
      .min_weight = 1.0 / 255,
      .area_shading = AreaShading::center,
      .fog_extent = FogExtent::outside_objects,
      .rounding = Rounding::half_up},
     {.width = 320, .height = 240},
     Handedness::either},
    {"nff",
     {.mirror = MirrorRule::add, .limit = LimitRule::drop, .min_weight = 0.01},
     {.width = 512, .height = 512, .shading = Shading::phong, .reflections = 5}},
    {"tachyon",
     {.offset = Offset::direction,
      .mirror = MirrorRule::add,
      .limit = LimitRule::background,
      .transparency = Transparency::add,
      .transparency_counts = true,
      .facing = Facing::winding,
      .spot_falloff = SpotFalloff::linear,
      .clamp_attenuation = false,
      .attenuate_highlights = false,
      .light_threshold = 0.001959,
      .rounding = Rounding::down},
     {.width = 512, .height = 512, .reflections = 11},
     Handedness::left},
    {"glint", {}, {}},
};

constexpr auto k_names = [] {
    std::array<std::string_view, std::size(k_profiles)> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = k_profiles[i].name;
    return names;
}();

}  // namespace

std::span<const Profile> profiles() { return k_profiles; }

std::span<const std::string_view> profile_names() { return k_names; }

Status apply_profile(Scene& scene, std::string_view profile) {
    return result_of([&]() -> Status {
        for (const Profile& p : k_profiles) {
            if (p.name != profile) continue;
            scene.origins.assign(setting_keys().size(), SettingOrigin{});
            scene.conventions = p.conventions;
            scene.settings = p.settings;
            scene.profile = p.name;
            return {};
        }
        return invalid_argument("there is no profile " + quoted(profile));
    });
}

}  // namespace glint
