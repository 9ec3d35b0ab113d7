// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether the numbers of shapes, materials and lights in an Explanation or a World are those of a scene.
#include <string>

#include "glint/explain.h"
#include "world/world.h"

namespace glint {

/// Why the world cannot be one of this scene, or an empty string: how many shapes and materials there are,
/// and which lights.
std::string world_fault(const Scene& scene, const WorldParts& world);

/// Why the explanation's rays cannot be of this scene, or an empty string: what they refer to, and each
/// other.
std::string explanation_fault(const Explanation& explanation, const Scene& scene);

}  // namespace glint
