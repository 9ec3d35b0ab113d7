#pragma once
#include <cstdint>

#include "world/world.h"

namespace glint {

/// The padded box of the shape in a bounded slot, as rays are tested against it: stored, or computed from a
/// triangle's vertices.
Bounds primitive_bounds(const World& world, std::uint32_t slot);

}  // namespace glint
