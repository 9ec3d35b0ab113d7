// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "world/world.h"

namespace glint {

/// Sets parts.interiors from all other parts.
void set_interiors(WorldParts& parts);

/// The objects that contain a point where a camera ray starts.
std::uint32_t camera_interiors_at(const WorldParts& parts, Vec3 origin);

}  // namespace glint
