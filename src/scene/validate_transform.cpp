// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_transform.h"

#include "math/number.h"
#include "math/transform.h"
#include "scene/parallel.h"
#include "scene/ranges.h"

namespace glint {

std::string_view mistake_in(const Affine& map) {
    const auto& m = map.m;
    bool finite = true;
    Vec3 rows[3];
    for (int r = 0; r < 3; ++r) {
        for (const double x : m[r]) finite = finite && k_coordinate.contains(x);
        rows[r] = {m[r][0], m[r][1], m[r][2]};
    }
    if (!finite) return ": expected numbers from -1e12 to 1e12";
    const double volume = dot(cross(unit_or_zero(rows[0]), unit_or_zero(rows[1])), unit_or_zero(rows[2]));
    if (!(number::abs(volume) >= k_parallel)) return " flattens what it transforms: it has no inverse";
    return {};
}

}  // namespace glint
