// SPDX-License-Identifier: Apache-2.0
#pragma once
// The mistakes that are tried: each changes the computation of one quantity, and what follows from it.
#include <cstdint>
#include <span>
#include <string_view>

#include "diagnose/trace_log.h"

namespace glint {

enum class TracerMistake : std::uint8_t {
    none,
    // direction of camera rays
    columns_mirrored,
    rows_flipped,
    pixel_corner,
    pixel_center,
    pixel_opposite_corner,
    pixel_over_last,
    aspect_ignored,
    aspect_inverted,
    aspect_twice,
    pixel_transposed,
    fov_not_halved,
    fov_halved_twice,
    fov_in_degrees,
    fov_other_axis,
    camera_backwards,
    camera_not_rotated,
    camera_up_not_orthogonal,
    viewport_point,
    // of secondary rays
    mirror_into_surface,
    mirror_backwards,
    mirror_not_doubled,
    mirror_along_normal,
    mirror_straight_on,
    mirror_of_light,
    refraction_inverted,
    refraction_from_outside,
    refraction_ignored,
    secondary_from_camera,
    // hits
    far_root,
    near_root_only,
    behind_origin,
    first_shape,
    last_shape,
    farthest_shape,
    self_hit,
    quadratic_of_unit,
    // points and normals
    point_without_origin,
    point_unit_direction,
    point_from_camera,
    normal_reversed,
    normal_of_origin,
    normal_not_turned,
    normal_not_unit,
    normal_transform,
    normal_untransformed,
    normal_from_center,
    view_reversed,
    view_is_eye,
    view_to_camera,
    view_not_unit,
    // lights
    light_reversed,
    light_is_position,
    light_from_origin,
    directional_as_point,
    light_not_unit,
    distance_squared,
    distance_of_origin,
    distance_is_t,
    distance_of_unit,
    attenuation_missing,
    attenuation_linear,
    attenuation_fourth_power,
    attenuation_without_constant,
    attenuation_squared_only,
    attenuation_above_one,
    attenuation_of_unit,
    attenuation_inverted,
    spot_missing,
    spot_hard_outer,
    spot_hard_inner,
    spot_half_angles,
    spot_double_angles,
    spot_radians,
    spot_reversed,
    spot_linear,
    cosine_absolute,
    cosine_of_view,
    cosine_light_not_unit,
    reflected_reversed,
    reflected_not_doubled,
    half_difference,
    half_not_unit,
    highlight_of_light,
    highlight_reversed,
    highlight_absolute,
    blinn_for_phong,
    phong_for_blinn,
    exponent_times_4,
    exponent_divided_4,
    exponent_missing,
    exponent_as_factor,
    power_exchanged,
    exponent_other,
    never_blocked,
    blocked_beyond_light,
    blocked_to_squared_distance,
    blocked_within_one,
    shadow_acne,
    shadow_ray_reversed,
    shadow_ray_from_origin,
    shadow_ray_late,
    shadow_inverted,
    shadow_behind_start,
    // terms
    diffuse_not_clamped,
    diffuse_absolute,
    diffuse_color_missing,
    diffuse_light_missing,
    diffuse_cosine_missing,
    diffuse_attenuation_missing,
    diffuse_shadow_ignored,
    diffuse_color_squared,
    diffuse_cosine_squared,
    diffuse_divided_by_lights,
    diffuse_divided_by_pi,
    specular_color_missing,
    specular_surface_color,
    specular_light_missing,
    specular_times_cosine,
    specular_gate_missing,
    specular_gate_added,
    specular_shadow_ignored,
    specular_attenuation_missing,
    ambient_missing,
    ambient_without_light,
    ambient_without_surface,
    ambient_is_diffuse,
    ambient_per_light,
    // sums
    local_without_ambient,
    local_without_diffuse,
    local_without_specular,
    local_without_emission,
    local_last_light,
    local_first_light,
    local_logged_only,
    local_mean,
    local_black_in_shadow,
    local_clamped,
    depth_one_more,
    depth_one_less,
    depth_none,
    total_reflection_ignored,
    weight_missing,
    weight_complement,
    weight_untinted,
    fresnel_missing,
    glass_tint_missing,
    glass_tint_twice,
    mirror_added,
    mirror_blended,
    mirror_swapped,
    weight_not_multiplied,
    limit_dropped,
    limit_kept,
    mirror_color_missing,
    mirror_without_local,
    mirror_unweighted,
    glass_own_light,
    color_clamped_before,
    color_scaled,
    // the pixel
    clamp_missing,
    clamp_scaled,
    clamp_toned,
    bytes_truncated,
    bytes_times_256,
    bytes_rounded_up,
    bytes_wrapped,
    bytes_gamma,
    bytes_srgb,
    bytes_swapped,
    bytes_integer_division,
    bytes_signed,
};
inline constexpr int k_mistakes = static_cast<int>(TracerMistake::bytes_signed) + 1;

/// Whether it changes the rays of the camera.
inline bool is_of_camera(TracerMistake mistake) {
    return mistake >= TracerMistake::columns_mirrored && mistake <= TracerMistake::viewport_point;
}

struct MistakeInfo {
    TracerMistake mistake;
    std::string_view id;
    Quantity at;  ///< the quantity whose computation it changes
    std::string_view explanation;
    /// It depends on the last bits of a program's numbers, so that it is reproduced at most places only.
    bool is_noisy = false;
    int variants = 1;  ///< ways of making it, which are tried one by one
};

/// In the order of TracerMistake, without `none`.
std::span<const MistakeInfo> mistake_infos();
const MistakeInfo& info_of(TracerMistake mistake);

}  // namespace glint
