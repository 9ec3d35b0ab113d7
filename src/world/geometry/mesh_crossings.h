// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where a line enters and leaves a closed mesh: for the operands of solids.
#include <cstdint>
#include <vector>

#include "world/geometry/packed_geometry.h"

namespace glint {

struct MeshCrossing {
    double t = 0;
    std::uint32_t triangle = 0;
};

/// The crossings of a line of the world with the mesh of a shape, by t: the line is inside between the first
/// and the second, the third and the fourth... Their number is even. A line that meets an edge or a vertex
/// crosses it as if the line were moved by an infinitely small distance.
std::vector<MeshCrossing> find_mesh_crossings(const PackedGeometry& geometry, std::uint32_t slot, Vec3 origin,
                                              Vec3 direction);

}  // namespace glint
