// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the rays of an explanation cross the shapes of the solids that they hit.
#include "glint/explain.h"
#include "trace/kernels.h"

namespace glint {

/// Sets ExplainedHit::crossings. scene: that of the world.
void find_solid_crossings(const Scene& scene, const WorldParts& world, const Kernels& kernels,
                          Explanation& explanation);

}  // namespace glint
