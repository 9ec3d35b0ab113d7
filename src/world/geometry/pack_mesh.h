// SPDX-License-Identifier: Apache-2.0
#pragma once
// Builds the hierarchies of a scene's meshes.
#include "glint/world.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// Packs the meshes that shapes of the valid scene have. Those that `meshes` has already are kept. False if
/// cancelled; throws only std::bad_alloc.
bool pack_meshes(const Scene& scene, PackedMeshes& meshes, const PrepareOptions& options);

/// Of all meshes of the scene, also of those that no shape has.
double count_mesh_triangles(const Scene& scene);

/// The options for a part of the work, whose progress is from `from` to `to` of the whole.
PrepareOptions part_of(const PrepareOptions& options, double from, double to);

}  // namespace glint
