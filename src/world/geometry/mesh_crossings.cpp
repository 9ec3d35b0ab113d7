// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/mesh_crossings-inl.h"

namespace glint {

std::vector<MeshCrossing> find_mesh_crossings(const PackedGeometry& geometry, std::uint32_t slot, Vec3 origin,
                                              Vec3 direction) {
    const HWY_NAMESPACE::Ray<double> line{{origin.x, origin.y, origin.z},
                                          {direction.x, direction.y, direction.z}};
    std::vector<MeshCrossing> crossings;
    HWY_NAMESPACE::find_crossings_of_mesh(geometry, slot, &line, 1, &crossings);
    return crossings;
}

}  // namespace glint
