// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "world/world.h"

namespace glint {

/// The fixed sequence of directions has this number of blocks, each with one direction for each sample.
inline constexpr int k_occlusion_blocks = 16;

void set_fog(WorldParts& parts, const std::optional<Fog>& fog);
void set_gradient(const std::optional<BackgroundGradient>& gradient, WorldParts& parts);
void set_occlusion(const std::optional<Occlusion>& occlusion, WorldParts& parts);

/// The first `count` directions of Tachyon's sequence for ambient occlusion: unit vectors in single
/// precision, evenly distributed over the sphere. A point of the cube is rejected if it is outside the
/// sphere. (measured)
std::vector<Vec3> fixed_directions(std::size_t count);

}  // namespace glint
