// SPDX-License-Identifier: Apache-2.0
#pragma once
// Boxes as vectors of four floats (three used), with the compilers' vector types: exact operations only.
#include <cstdint>
#include <cstring>
#include <limits>

#include "math/aabb.h"

namespace glint {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; }

/// Three floats and 0. Reads four.
inline Float4 load3(const float* p) {
    Float4 f;
    std::memcpy(&f, p, sizeof f);
    return reinterpret_cast<Float4>(reinterpret_cast<Int4>(f) & Int4{-1, -1, -1, 0});
}

/// Empty until something is added. The fourth coordinate is unused.
struct Box4 {
    static constexpr float k_infinity = std::numeric_limits<float>::infinity();
    Float4 lo = {k_infinity, k_infinity, k_infinity, 0};
    Float4 hi = {-k_infinity, -k_infinity, -k_infinity, 0};

    void add(Float4 at_lo, Float4 at_hi) {
        lo = min4(lo, at_lo);
        hi = max4(hi, at_hi);
    }
    void add(const Box4& b) { add(b.lo, b.hi); }
    Aabb aabb() const { return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}; }
};

/// Half the surface area of a non-empty box, after its sides are multiplied by `scale`.
inline float half_area(const Box4& b, float scale) {
    const Float4 side = (b.hi - b.lo) * scale;
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
}

}  // namespace glint
