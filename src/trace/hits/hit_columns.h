// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "world/geometry/surface_id.h"

namespace glint {

/// Where the kernels write nearest hits, by ray: t and the surface. Padded by a vector.
struct HitColumns {
    double* t;               // t_max for a miss
    std::uint32_t* slot;     // k_none for a miss
    std::uint32_t* element;  // 0 for a miss

    HitColumns from(int first) const { return {t + first, slot + first, element + first}; }
    SurfaceId surface(int i) const { return {slot[i], element[i]}; }
    void set(int i, double new_t, SurfaceId id) const {
        t[i] = new_t;
        slot[i] = id.slot;
        element[i] = id.element;
    }
};

}  // namespace glint
