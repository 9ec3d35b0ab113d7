// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/fields.h"

namespace glint {

template <> struct FieldMembers<Occlusion> {
    using Any = std::variant<FieldMember<Occlusion, double, NumberType>,
                             FieldMember<Occlusion, std::int32_t, WholeType>,
                             FieldMember<Occlusion, Color, ColorType>>;
};
template <> struct FieldMembers<BackgroundGradient> {
    using Any = std::variant<FieldMember<BackgroundGradient, double, NumberType>,
                             FieldMember<BackgroundGradient, bool, BoolType>,
                             FieldMember<BackgroundGradient, Vec3, DirectionType>,
                             FieldMember<BackgroundGradient, Color, ColorType>>;
};

/// .glint also has `method`.
inline constexpr ItemField<Occlusion> k_occlusion_fields[] = {
    {"samples", "samples", "samples", whole_field(&Occlusion::samples, k_occlusion_samples),
     "directions in which each surface point is tested"},
    {"color", "color", "color", color_field(&Occlusion::color, k_channel, ColorUse::light),
     "the light from all directions"},
    {.key = "reach",
     .name = "reach",
     .label = "reach",
     .member = number_field(&Occlusion::reach, k_reach),
     .description = "shapes farther away do not block, in world units",
     .otherwise = "no limit"},
    {"direct", "direct", "direct", number_field(&Occlusion::direct, k_tint),
     "a factor of the light of all lights but the ambient ones"},
};

/// .glint also has `type`, the kind.
inline constexpr ItemField<BackgroundGradient> k_gradient_fields[] = {
    {"up", "up", "up", direction_field(&BackgroundGradient::up),
     "the direction along which the color changes"},
    {"bottom", "bottom", "bottom", number_field(&BackgroundGradient::bottom, k_coordinate),
     "the coordinate along `up` of the bottom color"},
    {"top", "top", "top", number_field(&BackgroundGradient::top, k_coordinate),
     "the coordinate along `up` of the top color, above bottom"},
    {"bottom_color", "bottom_color", "bottom color",
     color_field(&BackgroundGradient::bottom_color, k_channel, ColorUse::surface), "the color at `bottom`"},
    {"top_color", "top_color", "top color",
     color_field(&BackgroundGradient::top_color, k_channel, ColorUse::surface), "the color at `top`"},
    {"repeats", "repeats", "repeats", bool_field(&BackgroundGradient::repeats),
     "true: the colors repeat beyond bottom and top; false: they are constant there"},
};

}  // namespace glint
