// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/fields.h"

namespace glint {

template <> struct FieldMembers<Light> {
    using Any =
        std::variant<FieldMember<Light, double, NumberType>, FieldMember<Light, std::int32_t, WholeType>,
                     FieldMember<Light, bool, BoolType>, FieldMember<Light, Vec3, PointType>,
                     FieldMember<Light, Vec3, DirectionType>, FieldMember<Light, Color, ColorType>,
                     FieldMember<Light, Attenuation, AttenuationType>>;
};

/// .glint also has `type`, the kind, and `intensity`, a factor of both colors.
inline constexpr ItemField<Light> k_light_fields[] = {
    {"color", "color", "color", color_field(&Light::color, k_channel, ColorUse::light),
     "I_a, or I_l,d: times the intensity"},
    {.key = "specular_color",
     .name = "specular_color",
     .label = "specular color",
     .member = color_field(&Light::specular_color, k_channel, ColorUse::light),
     .description = "I_l,s: times the intensity",
     .applies = &Light::has_specular_color,
     .otherwise = "the color"},
    {.key = "position",
     .name = "position",
     .label = "position",
     .member = point_field(&Light::position),
     .description = "where the light is; the middle of an area light",
     .applies = &Light::has_position,
     .required = true,
     .phrase = "at"},
    {.key = "to_light",
     .name = "to_light",
     .label = "direction",
     .member = direction_field(&Light::to_light),
     .description = "towards the light",
     .applies = &Light::has_direction,
     .required = true,
     .other_key = "direction",
     .phrase = "towards"},
    {.key = "axis",
     .name = "axis",
     .label = "axis",
     .member = direction_field(&Light::axis),
     .description = "the middle of a spot's cone, or the normal of a disc, away from the light; or `target`, "
                    "a point on it",
     .applies = &Light::has_axis,
     .required = true,
     .phrase = "along"},
    {"inner_angle", "inner_angle", "inner angle", number_field(&Light::inner_angle, k_cone_angle),
     "degrees off the axis within which the light is full; at most outer_angle", &Light::is_spot},
    {"outer_angle", "outer_angle", "outer angle", number_field(&Light::outer_angle, k_cone_limit),
     "degrees off the axis beyond which there is no light", &Light::is_spot},
    {"tightness", "tightness", "tightness", number_field(&Light::tightness, k_exponent),
     "the exponent of the cosine off the axis, if `spot_falloff` is cubic", &Light::is_spot},
    {.key = "side_u",
     .name = "side_u",
     .label = "side u",
     .member = direction_field(&Light::side_u),
     .description = "one side; the position is in the middle",
     .applies = &Light::is_parallelogram,
     .required = true},
    {.key = "side_v",
     .name = "side_v",
     .label = "side v",
     .member = direction_field(&Light::side_v),
     .description = "the other side",
     .applies = &Light::is_parallelogram,
     .required = true},
    {.key = "radius",
     .name = "radius",
     .label = "radius",
     .member = number_field(&Light::radius, k_length),
     .description = "of the disc or sphere",
     .applies = &Light::has_radius,
     .required = true},
    {"samples_u", "samples_u", "samples u", whole_field(&Light::samples_u, k_light_samples),
     "samples along side_u; of a disc or sphere, rings", &Light::is_area},
    {"samples_v", "samples_v", "samples v", whole_field(&Light::samples_v, k_light_samples),
     "samples along side_v; of a disc or sphere, in each ring", &Light::is_area},
    {"one_sided", "one_sided", "one-sided", bool_field(&Light::one_sided),
     "true: only the side of side_u × side_v, or of `axis`, gives light, times the cosine off that normal",
     &Light::may_be_one_sided},
    {"jitter", "jitter", "jitter", bool_field(&Light::jitter),
     "true: the samples are moved within their cells, differently at each surface point", &Light::is_area},
    {"adaptive", "adaptive", "adaptive", whole_field(&Light::adaptive, k_level),
     "if `area_shading` is center: levels of the grid that are always divided; below them, where corners "
     "differ",
     &Light::is_area},
    {"circular", "circular", "circular", bool_field(&Light::circular),
     "true: the samples fill the ellipse in the parallelogram", &Light::is_parallelogram},
    {"oriented", "oriented", "oriented", bool_field(&Light::oriented),
     "true: each surface point sees a square with sides as long as side_u that faces it",
     &Light::is_parallelogram},
    {"cone", "cone", "cone", bool_field(&Light::cone),
     "true: the light is a spot, too: it has `axis`, `inner_angle`, `outer_angle` and `tightness`",
     &Light::is_parallelogram},
    {"attenuation", "attenuation", "attenuation", attenuation_field(&Light::attenuation),
     "min(1/(c0 + c1 d + c2 d^2), 1) at distance d; without the min if not `clamp_attenuation`",
     &Light::has_attenuation},
    {"fade_distance", "fade_distance", "fade distance", number_field(&Light::fade_distance, k_not_negative),
     "with fade_power, both > 0: a factor 2/(1 + (d/fade_distance)^fade_power)", &Light::has_attenuation},
    {"fade_power", "fade_power", "fade power", number_field(&Light::fade_power, k_exponent),
     "the power of the distance in that factor", &Light::has_attenuation},
    {"casts_shadows", "casts_shadows", "casts shadows", bool_field(&Light::casts_shadows),
     "false: nothing blocks the light", &Light::has_specular_color},
};

/// Whether the field is a color, which .glint multiplies by the intensity.
constexpr bool is_light_color(const ItemField<Light>& field) {
    return is_field_of(field, &Light::color) || is_field_of(field, &Light::specular_color);
}

}  // namespace glint
