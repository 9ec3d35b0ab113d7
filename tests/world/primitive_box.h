// SPDX-License-Identifier: Apache-2.0
#pragma once
// A slot's own padded box, stored or not.
#include <algorithm>

#include "math/aabb.h"
#include "world/world.h"

namespace glint::test {

inline Aabb primitive_box(const PackedGeometry& world, std::uint32_t slot) {
    Aabb box;
    if (slot < world.boxed) {
        for (int a = 0; a < 3; ++a) box.lo[a] = world.box_lo[a][slot], box.hi[a] = world.box_hi[a][slot];
        return box;
    }
    const ShapeClass& triangles = world.class_of(slot);
    double lo[3], hi[3];
    for (int a = 0; a < 3; ++a) {
        const auto at = [&](int vertex) { return triangles.column(3 * vertex + a)[slot - triangles.first]; };
        lo[a] = std::min({at(0), at(1), at(2)}), hi[a] = std::max({at(0), at(1), at(2)});
    }
    return padded_box({lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]});
}

}  // namespace glint::test
