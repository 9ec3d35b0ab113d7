// SPDX-License-Identifier: Apache-2.0
#pragma once
// Light that is lost inside objects (Material::fade_distance).
#include "world/world.h"

namespace glint {

/// The factor of light that comes to a surface's point in this direction, after a distance since the last
/// surface, and passes it. 1 where light enters the object, and if its material does not fade. Only in worlds
/// that use Material::fade_distance.
Color fade_at(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 direction, double distance);

}  // namespace glint
