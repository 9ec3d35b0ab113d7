// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's shapes into a PackedGeometry: sorted by kind, packed as columns under a hierarchy.
#include <optional>
#include <vector>

#include "glint/world.h"
#include "world/packed_geometry.h"
#include "world/primitives.h"

namespace glint {

/// The scene is valid. cones: whether the conventions draw them. Nothing if it was cancelled; throws only
/// std::bad_alloc.
std::optional<PackedGeometry> pack_shapes(const Scene& scene, bool cones, const PrepareOptions& options);

/// Writes all that a slot of the class has of a primitive. box: of one whose class stores it.
void write_primitive(const Primitives& primitives, const Primitive& primitive, const Aabb& box,
                     std::uint32_t slot, ShapeClass& shapes, PackedGeometry& geometry);

/// By slot, padded: the shape's row in a table of so many materials and the default one.
std::vector<std::uint32_t> find_slot_materials(const Scene& scene, const PackedGeometry& geometry,
                                               std::size_t materials, int threads);

}  // namespace glint
