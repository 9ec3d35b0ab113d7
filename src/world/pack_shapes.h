#pragma once
// Shapes into a World: cut, sorted by kind, packed as columns under a hierarchy.
#include "glint/scene.h"
#include "world/world.h"

namespace glint {

/// Fills all that the world holds of shapes. The scene is valid; throws only std::bad_alloc.
void pack_shapes(const Scene& scene, World& world, int threads);

}  // namespace glint
