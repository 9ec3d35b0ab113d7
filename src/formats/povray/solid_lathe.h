// SPDX-License-Identifier: Apache-2.0
#pragma once
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
};

/// Adds a line to those of a lathe; it continues the last one if it begins where that ends.
void add_lathe_line(const FlatLoop& line, LatheLines& lines);

/// Whether all lines are closed or end on the axis.
bool is_closed_lathe(const LatheLines& lines);

/// A lathe as a part of a solid: the merge of what is between two edges, turned around the axis. Found once
/// for each lathe. Null if it is open, or if its lines cross too often or have too many points.
std::shared_ptr<const Object> solid_lathe(const Object& lathe);

}  // namespace glint::povray
