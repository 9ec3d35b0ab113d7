// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "glint/scene.h"

namespace glint {

/// Whether a shape can be an operand of a solid: it encloses a space, or a half of it.
bool encloses_space(const Scene& scene, const Shape& shape);

/// What is wrong with the steps of a solid, which are postfix; empty: nothing.
std::string mistake_in_steps(const SolidTree& tree);

}  // namespace glint
