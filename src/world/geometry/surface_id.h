// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "glint/scene.h"

namespace glint {

/// Which surface a ray hit.
struct SurfaceId {
    std::uint32_t slot = k_none;  // of the PackedGeometry; k_none: no surface
    /// An index into the parts of the slot's shape, in a fixed order: the triangle of a polygon or of a mesh,
    /// which may be an operand; else the operand of a solid. 0 for shapes without parts.
    std::uint32_t element = 0;

    bool exists() const { return slot != k_none; }
    bool operator==(const SurfaceId&) const = default;
};

}  // namespace glint
