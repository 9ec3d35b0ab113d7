// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "world/world.h"

namespace glint {

/// Sets parts.interiors from all other parts.
void set_interiors(WorldParts& parts);

}  // namespace glint
