// SPDX-License-Identifier: Apache-2.0
#pragma once
// Packs the solids of a scene, whose operands have slots.
#include <cstdint>
#include <span>

#include "world/geometry/packed_solid.h"
#include "world/geometry/primitives.h"

namespace glint {

/// slots: by operand of the Primitives. Also writes the solid's part of `operands`, by slot from `first` on.
PackedSolid pack_solid(const Primitives& primitives, const PrimitiveSolid& solid,
                       std::span<const std::uint32_t> slots, std::uint32_t first,
                       std::span<PackedOperand> operands);

}  // namespace glint
