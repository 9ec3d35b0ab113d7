// SPDX-License-Identifier: Apache-2.0
#pragma once
// Single-precision axis-aligned boxes that contain the double-precision boxes they were made from.
#include <limits>

#include "glint/vec.h"
#include "math/number.h"
#define GLINT_NUMBER_NAMESPACE number
#include "math/padding_templates-inl.h"

namespace glint {

/// Empty at first: lo > hi.
struct Aabb {
    float lo[3] = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                   std::numeric_limits<float>::infinity()};
    float hi[3] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                   -std::numeric_limits<float>::infinity()};

    void add(const Aabb& b) {
        for (int a = 0; a < 3; ++a) {
            if (b.lo[a] < lo[a]) lo[a] = b.lo[a];
            if (b.hi[a] > hi[a]) hi[a] = b.hi[a];
        }
    }
    bool empty() const { return !(lo[0] <= hi[0]); }
    /// Half the surface area; 0 if empty.
    float half_area() const {
        if (empty()) return 0;
        const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x * y + y * z + z * x;
    }
};

/// The ends of the box of a shape without ends, as a half-space: beyond all coordinates.
inline constexpr float k_endless = 4e12f;

inline bool is_endless(const Aabb& box) {
    for (int a = 0; a < 3; ++a) {
        if (box.lo[a] <= -k_endless || box.hi[a] >= k_endless) return true;
    }
    return false;
}

/// The box in single precision of a box in double, with its padding.
inline Aabb padded_box(Vec3 lo, Vec3 hi) {
    const double low[3] = {lo.x, lo.y, lo.z}, high[3] = {hi.x, hi.y, hi.z};
    Aabb box;
    for (int a = 0; a < 3; ++a) {
        const double pad = number::box_padding(low[a], high[a]);
        box.lo[a] = static_cast<float>(low[a] - pad);
        box.hi[a] = static_cast<float>(high[a] + pad);
    }
    return box;
}

}  // namespace glint
