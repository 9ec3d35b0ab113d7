// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether points are inside of shapes.
#include <cstdint>

#include "glint/vec.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// Whether a point is inside of the shape, operand or solid of a slot. Inside of a plane is opposite to its
/// normal. A clipped solid contains what it would contain without its clips, as in POV-Ray. Shapes that
/// enclose no space contain no point.
bool contains(const PackedGeometry& geometry, std::uint32_t slot, Vec3 point);

}  // namespace glint
