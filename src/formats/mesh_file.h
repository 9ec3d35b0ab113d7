// SPDX-License-Identifier: Apache-2.0
#pragma once
// Files of meshes: as scenes of their own, and as the meshes of scenes.
#include <memory>
#include <optional>
#include <string>

#include "formats/load_state.h"
#include "glint/mesh.h"

namespace glint {

/// Reads a text as one mesh. Null after an error.
using MeshReader = std::shared_ptr<const MeshData> (*)(LoadState& reading, InputText where);
std::shared_ptr<const MeshData> read_ply_mesh(LoadState& reading, InputText where);
std::shared_ptr<const MeshData> read_stl_mesh(LoadState& reading, InputText where);
/// Without the materials.
std::shared_ptr<const MeshData> read_obj_mesh(LoadState& reading, InputText where);

/// Adds the mesh of a text to the scene, as a shape with the default material.
void read_mesh_text(LoadState& reading, const ReadText& text, MeshReader read);

/// The index in Scene::meshes of the mesh in file `name`, relative to the text `from`; a file is read once.
/// Nothing after an error; one of the file's name is reported at `at`.
std::optional<std::uint32_t> mesh_of_file(LoadState& reading, const ReadText& from, const Token& at,
                                          const std::string& name);

/// By mesh: the name in Scene::files of the file that it was read from; empty: none.
std::vector<std::string> mesh_file_names(const Scene& scene);

}  // namespace glint
