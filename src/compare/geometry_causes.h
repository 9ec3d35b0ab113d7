// SPDX-License-Identifier: Apache-2.0
#pragma once
// Causes with numbers that are fitted by rendering: another position, size or color.
#include <vector>

#include "compare/fitted_cause.h"
#include "compare/shape_shares.h"

namespace glint {

/// Lights, the camera and spheres with another position or size, materials and the background with another
/// color. Spheres and materials are only those of the first shapes of `shares`.
std::vector<FittedCause> geometry_causes(const SceneRenderer& renderer,
                                         const std::vector<ShapeShare>& shares);

}  // namespace glint
