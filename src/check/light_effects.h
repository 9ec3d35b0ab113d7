// SPDX-License-Identifier: Apache-2.0
#pragma once
// What lights add to the picture, found by rendering it with them alone.
#include <map>
#include <span>
#include <vector>

#include "check/checks.h"

namespace glint {

/// The longest sides of the pictures that are rendered, in pixels.
inline constexpr std::int32_t k_first_look = 160, k_second_look = 480;
/// The lights that are rendered alone in pictures of full size.
inline constexpr std::size_t k_full_looks = 8;
/// A light that adds less than this to every pixel is hardly visible.
inline constexpr double k_faint = 0.06;

/// How much two pictures differ.
struct Effect {
    double most = 0;   ///< in a channel of a pixel
    double share = 0;  ///< of the pixels, where it is visible
    double core = 0;   ///< of the pixels, where it is at least half of the most
};
Effect effect_of(const Image& a, const Image& b);

/// What lights add to the picture.
class Effects {
  public:
    explicit Effects(CheckContext& context) : context_(context) {}

    /// Of some lights of the scene, together.
    Effect of(std::span<const std::uint32_t> lights, std::int32_t longest);
    /// Of other lights.
    Effect of(const std::vector<Light>& lights, std::int32_t longest);

  private:
    Image render_with(const std::vector<Light>& lights, std::int32_t longest) {
        return context_.render_small(with_lights(context_.prepared(), lights), longest);
    }

    CheckContext& context_;
    std::map<std::int32_t, Image> dark_;  // by longest side
};

/// Colors and intensities that are probably mistakes. False if the light is black.
bool check_light_color(CheckContext& context, std::uint32_t index);
/// Lights that are equal to others, or would be but for a tiny difference in their place.
void check_equal_lights(CheckContext& context, const VisibleHits& visible);
/// A point light or spot on a surface that blocks light. False if it is: nothing else is said of the light
/// then.
bool check_place(CheckContext& context, std::uint32_t index);
/// Spherical lights that contain shapes.
void check_lights_around(CheckContext& context, const VisibleHits& visible);
/// A spot whose angles are probably radians. False if they are: nothing else is said of the light then.
bool check_spot_angle(CheckContext& context, Effects& effects, std::uint32_t index);
/// A spot so tight that its light is a dot. False if it is.
bool check_spot_tightness(CheckContext& context, Effects& effects, std::uint32_t index);
/// Lights of which attenuation leaves almost nothing. faint: lights that add less than k_faint to any pixel.
void check_attenuation(CheckContext& context, const VisibleHits& visible, Effects& effects,
                       std::span<const std::uint32_t> faint);

/// Area lights whose picture is the same with a quarter of the samples, and those with one.
void check_light_samples(CheckContext& context);

}  // namespace glint
