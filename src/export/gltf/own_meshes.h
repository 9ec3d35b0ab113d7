// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes that only one shape has.
#include "glint/mesh.h"
#include "glint/texture.h"
#include "glint/vec.h"

namespace glint::gltf_export {

/// The mesh in other coordinates. A mirrored one has its triangles turned, as glTF turns them for nodes.
MeshData transformed(const MeshData& mesh, const Affine& map);

/// The mesh with the coordinates that a texture's mapping has at its vertices. Triangles across the line
/// where u jumps from 1 to 0 go on beyond 1.
MeshData with_coordinates(const MeshData& mesh, const Affine& world_from_mesh, const Texture& texture);

}  // namespace glint::gltf_export
