// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checks that the indices in an Explanation or a World are those of a scene.
#include <string>

#include "glint/explain.h"
#include "world/world.h"

namespace glint {

/// The reason why the world cannot belong to this scene, or an empty string. Compares the numbers of shapes
/// and materials, and the lights.
std::string world_fault(const Scene& scene, const WorldParts& world);

/// The reason why the explanation's rays cannot belong to this scene, or an empty string. Checks the indices
/// of the scene's items and of other rays.
std::string explanation_fault(const Explanation& explanation, const Scene& scene);

}  // namespace glint
