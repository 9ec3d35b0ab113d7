// SPDX-License-Identifier: Apache-2.0
#pragma once
// Builds the hierarchies of a scene's meshes.
#include "glint/world.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// Packs the meshes that shapes of the valid scene have. Those that `meshes` has already are kept. False if
/// cancelled; throws only std::bad_alloc.
bool pack_meshes(const Scene& scene, PackedMeshes& meshes, const PrepareOptions& options);

}  // namespace glint
