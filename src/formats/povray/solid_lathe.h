// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <string_view>

#include "formats/povray/even_odd.h"
#include "formats/povray/object.h"

namespace glint::povray {

/// The lines of a lathe, each closed or with both ends on the axis: x is the distance from it. What an odd
/// number of them surrounds is inside.
struct LatheLines {
    CountedVector<FlatLoop> loops;
    // What solid_lathe() has found.
    mutable bool is_known = false;
    mutable std::shared_ptr<const Object> solid;
    mutable std::string_view reason;  // why there is none
    mutable std::uint64_t steps = 0;  // that it took, and that are not counted yet
};

/// Adds a line to those of a lathe; it continues the last one if it begins where that ends.
void add_lathe_line(const FlatLoop& line, LatheLines& lines);

/// A lathe as a part of a solid: the merge of what is between two edges, turned around the axis. Found once
/// for each lathe. Null if it has none, for LatheLines::reason.
std::shared_ptr<const Object> solid_lathe(const Object& lathe);

/// The number of shapes that an object is in a solid.
std::uint64_t count_operands(const Object& object);
/// The steps that the lathes in an object took and that were not taken before.
std::uint64_t take_lathe_steps(const Object& object);

}  // namespace glint::povray
