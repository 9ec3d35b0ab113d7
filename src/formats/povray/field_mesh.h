// SPDX-License-Identifier: Apache-2.0
#pragma once
// height_field: a grid of heights, and its mesh.
#include <memory>

#include "formats/povray/object.h"

namespace glint::povray {

/// Heights in parts of 65536, rows from z = 0 on. At least 2 x 2.
struct HeightField {
    CountedVector<std::uint16_t> heights;
    std::uint32_t width = 0, depth = 0;
    double water = 0;  ///< in parts of 65536: what is below is cut off
    bool is_smooth = false;
};

/// What the mesh of a field may take.
std::uint64_t bytes_of_mesh(const HeightField& field);

struct FieldMeshResult {
    std::shared_ptr<const MeshData> data;
    bool is_coarse = false;  ///< too many squares would have to be divided for POV-Ray's normals
};

/// The mesh of a field with its map: x and z are the numbers of vertices, y is the height in parts of 65536.
FieldMeshResult mesh_of_field(const HeightField& field, const Affine& object_from_world);

/// The map to the cube from 0 to 1.
Affine cube_from_grid(const HeightField& field);

}  // namespace glint::povray
