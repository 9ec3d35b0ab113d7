// SPDX-License-Identifier: Apache-2.0
#pragma once
// Area lights in place of lights without an extent.
#include <vector>

#include "compare/fitted_cause.h"

namespace glint {

/// Appends the cause "shadows-soft" for each point light and directional light that casts shadows, and for
/// all point lights together: a sphere with a fitted radius, then a form of light, sizes and samples
/// (FittedCause::refined). `scene` must outlive them.
void add_soft_shadows(const Scene& scene, std::vector<FittedCause>& causes);

}  // namespace glint
