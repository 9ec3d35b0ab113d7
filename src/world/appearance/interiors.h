// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "world/world.h"

namespace glint {

/// Sets what parts.interiors, which has its defaults otherwise, has besides without_fog.
void find_interiors(WorldParts& parts);

/// Sets parts.interiors from all other parts.
inline void set_interiors(WorldParts& parts) {
    parts.interiors = {};
    parts.interiors.without_fog = parts.fog && parts.conventions.fog_extent == FogExtent::outside_objects;
    if (parts.interiors.without_fog || parts.uses<&Material::refracts>()) find_interiors(parts);
}

/// The objects that contain a point where a camera ray starts.
std::uint32_t camera_interiors_at(const WorldParts& parts, Vec3 origin);

}  // namespace glint
