// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/fields.h"

namespace glint {

template <> struct FieldMembers<Light> {
    using Any = std::variant<FieldMember<Light, double, NumberType>, FieldMember<Light, Vec3, PointType>,
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
     .description = "where the light is",
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
    {"attenuation", "attenuation", "attenuation", attenuation_field(&Light::attenuation),
     "min(1/(c0 + c1 d + c2 d^2), 1) at distance d", &Light::has_attenuation},
};

/// Whether the field is a color, which .glint multiplies by the intensity.
constexpr bool is_light_color(const ItemField<Light>& field) {
    return is_field_of(field, &Light::color) || is_field_of(field, &Light::specular_color);
}

}  // namespace glint
