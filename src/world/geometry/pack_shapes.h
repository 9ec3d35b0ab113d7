// SPDX-License-Identifier: Apache-2.0
#pragma once
// Packs a scene's shapes into a PackedGeometry: columns sorted by kind, and a hierarchy.
#include <optional>
#include <vector>

#include "glint/world.h"
#include "world/geometry/packed_geometry.h"
#include "world/geometry/primitives.h"

namespace glint {

/// The scene must be valid. cones: whether the conventions include them. Nothing if cancelled; throws only
/// std::bad_alloc.
std::optional<PackedGeometry> pack_shapes(const Scene& scene, bool cones, const PrepareOptions& options);

/// Writes all values of a primitive but its box to a slot of its class.
void write_primitive(const Primitives& primitives, const Primitive& primitive, std::uint32_t slot,
                     ShapeClass& shapes, PackedGeometry& geometry);
/// Writes the box of a slot that stores one.
void write_box(const Aabb& box, std::uint32_t slot, PackedGeometry& geometry);

/// By slot, padded: the row of the shape's material in a table of `materials` rows and the default one.
std::vector<std::uint32_t> find_slot_materials(const Scene& scene, const PackedGeometry& geometry,
                                               std::size_t materials, int threads);

}  // namespace glint
