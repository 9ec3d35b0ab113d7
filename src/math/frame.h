// SPDX-License-Identifier: Apache-2.0
#pragma once
// Axes across a direction.
#include "glint/vec.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {

/// Unit vectors at right angles to a unit vector and to each other.
struct AcrossAxes {
    Vec3 x, y;

    explicit AcrossAxes(Vec3 unit) {
        const Vec3 other = number::abs(unit.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        x = normalize(cross(unit, other));
        y = cross(unit, x);
    }
};

}  // namespace glint
