// SPDX-License-Identifier: Apache-2.0
#pragma once
// The order in which the parts of a rubric are judged, which does not depend on the order of its lines.
#include <vector>

#include "grade/rubric.h"

namespace glint {

/// Rows that require the same pictures; they are judged together.
struct EqualRows {
    std::vector<std::size_t> rows;  ///< indices; the first has the fewest points
    std::size_t first() const { return rows.front(); }
};

/// All rows: those with the fewest points first, and of equal points by name, file and settings.
std::vector<EqualRows> judging_order(const std::vector<RubricRow>& rows);

}  // namespace glint
