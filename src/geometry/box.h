#pragma once
// Axis-aligned boxes in single precision that contain what they were made from in double.
#include <bit>
#include <cstdint>
#include <limits>

#include "glint/vec.h"

namespace glint {

/// Empty until something is added: lo > hi.
struct Box {
    float lo[3] = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                   std::numeric_limits<float>::infinity()};
    float hi[3] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                   -std::numeric_limits<float>::infinity()};

    void add(const Box& b) {
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

/// A float below x by one to two units in the last place: padding for what a double formula's rounding may move.
inline float padded_below(double x) {
    const float f = static_cast<float>(x);
    return f - ((f < 0 ? -f : f) * 0x1p-23f + 1e-35f);
}
inline float padded_above(double x) { return -padded_below(-x); }

/// The padded box of a box given in double.
inline Box padded_box(Vec3 lo, Vec3 hi) {
    Box box;
    box.lo[0] = padded_below(lo.x), box.lo[1] = padded_below(lo.y), box.lo[2] = padded_below(lo.z);
    box.hi[0] = padded_above(hi.x), box.hi[1] = padded_above(hi.y), box.hi[2] = padded_above(hi.z);
    return box;
}

}  // namespace glint
