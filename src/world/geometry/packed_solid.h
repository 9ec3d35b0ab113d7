// SPDX-License-Identifier: Apache-2.0
#pragma once
// A solid whose operands are packed.
#include <cstdint>
#include <vector>

#include "glint/solid.h"

namespace glint {

/// What the kernels do, in order: a combination begins, its parts follow, it ends.
struct SolidItem {
    enum class Kind : std::uint8_t { begin, operand, end };
    Kind kind = Kind::operand;
    SolidOperation operation = SolidOperation::operand;
    std::uint32_t operand = 0;
};

/// A shape that a solid consists of.
struct PackedOperand {
    float reach = 0;            // the largest coordinate of its box; 0 for planes
    bool is_inverted = false;   // the solid is where the operand is not: its normal is turned
    bool has_material = false;  // its own, not the solid's
};

struct PackedSolid {
    std::vector<SolidItem> items;
    std::vector<std::uint32_t> slots;  // by operand
    std::vector<float> lo[3], hi[3];   // by operand, padded: its padded box; infinite for planes
};

}  // namespace glint
