// SPDX-License-Identifier: Apache-2.0
#pragma once
// Light that objects lose (Material::fade_distance) or concentrate (Material::caustics).
#include "world/world.h"

namespace glint {

/// The factor of light that comes to a surface's point in this direction, after a distance since the last
/// surface, and passes it. 1 where light enters the object, and if its material does not fade. Only in worlds
/// that use Material::fade_distance.
Color fade_at(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 direction, double distance);

/// The factor by which a transparent surface makes the light of a shadow ray of this direction, of any
/// length, brighter at a point: 1 + |N.L|^caustics. 1 if its material has no caustics. Only in worlds that
/// use Material::caustics.
double caustics_at(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 direction);

}  // namespace glint
