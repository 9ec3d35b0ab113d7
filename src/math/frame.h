// SPDX-License-Identifier: Apache-2.0
#pragma once
// Orthonormal frames.
#include "math/number.h"
#include "math/transform.h"

namespace glint {

/// Unit vectors at right angles to each other.
struct Frame {
    Vec3 x, y, z;

    Frame() = default;
    /// The frame with this z axis, a unit vector.
    explicit Frame(Vec3 unit) : z(unit) {
        const Vec3 other = number::abs(unit.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        x = normalize(cross(unit, other));
        y = cross(unit, x);
    }
};

}  // namespace glint
