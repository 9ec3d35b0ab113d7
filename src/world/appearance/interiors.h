// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "world/world.h"

namespace glint {

/// For fog outside of objects: sets parts.interiors, which has its defaults.
void find_interiors(WorldParts& parts);

/// Sets parts.interiors from all other parts.
inline void set_interiors(WorldParts& parts) {
    parts.interiors = {};
    if (parts.fog && parts.conventions.fog_extent == FogExtent::outside_objects) find_interiors(parts);
}

/// The objects that contain a point where a camera ray starts.
std::uint32_t camera_interiors_at(const WorldParts& parts, Vec3 origin);

}  // namespace glint
