// SPDX-License-Identifier: Apache-2.0
#pragma once
// The holes of textures that the rays of an explanation pass.
#include "glint/explain.h"
#include "world/world.h"

namespace glint {

/// Sets ExplainedRay::holes and hole_count.
void find_holes(const WorldParts& world, Explanation& explanation);

}  // namespace glint
