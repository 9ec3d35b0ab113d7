// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/fields.h"

namespace glint {

/// .glint also has `type`, the kind.
inline constexpr ItemField<Fog> k_fog_fields[] = {
    {"color", "color", "color", color_field(&Fog::color, k_channel, ColorUse::surface), "the fog's color"},
    {.key = "density",
     .name = "density",
     .label = "density",
     .member = number_field(&Fog::density, k_not_negative),
     .description = "how fast it thickens, per world unit",
     .applies = &Fog::has_density},
    {"start", "start", "start", number_field(&Fog::start, k_coordinate), "the distance at which it begins"},
    {.key = "end",
     .name = "end",
     .label = "end",
     .member = number_field(&Fog::end, k_coordinate),
     .description = "the distance from which on nothing else is seen, above start",
     .applies = &Fog::has_end},
    {"transmit", "transmit", "transmit", number_field(&Fog::transmit, k_fraction),
     "the least part that is seen of what is behind it"},
    {"filter", "filter", "filter", number_field(&Fog::filter, k_fraction),
     "how far the fog's color tints what is seen through it"},
    {.key = "falloff",
     .name = "falloff",
     .label = "falloff",
     .member = number_field(&Fog::falloff, k_not_negative),
     .description = "above 0: from `height` to this much above, the density halves",
     .applies = &Fog::has_falloff},
    {.key = "height",
     .name = "height",
     .label = "height",
     .member = number_field(&Fog::height, k_coordinate),
     .description = "with a falloff: the coordinate along `up` below which the density is whole",
     .applies = &Fog::is_on_ground},
    {.key = "up",
     .name = "up",
     .label = "up",
     .member = direction_field(&Fog::up),
     .description = "with a falloff: away from the ground",
     .applies = &Fog::is_on_ground},
};

}  // namespace glint
