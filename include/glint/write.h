// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes and meshes to files.
#include <span>
#include <string>
#include <string_view>

#include "glint/export.h"
#include "glint/load.h"
#include "glint/result.h"
#include "glint/scene.h"

namespace glint {

/// The scene in glint's own language (docs/formats/glint.md), for people to read and edit. load() reads it
/// back as a scene that renders to the same bits. Numbers are the shortest that read back as the same double.
/// texts: the texts that the scene was read from, included ones too, each under its name in Scene::files;
/// their comments are kept with their items. An error if validate() finds one in the scene. Never throws.
/// Time and memory are proportional to the scene and the texts. mesh_files: by index in Scene::meshes, the
/// name of a file that has the mesh, relative to that of the text, which is read from it; without a name, or
/// past the end of the list, the mesh is written into the text.
GLINT_API Result<std::string> write_glint(const Scene& scene, std::span<const SceneText> texts = {},
                                          std::span<const std::string> mesh_files = {});

/// A format that write_scene() writes.
struct WrittenFormat {
    std::string_view name;       ///< "glb"
    std::string_view extension;  ///< of the names of such files, ".glb"
    std::string_view description;
};
GLINT_API std::span<const WrittenFormat> written_formats();

/// The bytes of a file in one of these formats, by its name. The diagnostics of the result are warnings of
/// what the format cannot say: one for each kind of things that are left out or approximated
/// (docs/formats/gltf.md). The same scene gives the same bytes. Errors: no such format, one that validate()
/// finds in the scene, and a .glb that would be larger than 4 GiB. Never throws. Time and memory are
/// proportional to the scene.
GLINT_API Result<std::string> write_scene(const Scene& scene, std::string_view format);

/// The mesh as a binary .ply file (docs/formats/ply.md), little endian. load() reads it back with the same
/// positions, normals, colors and texture coordinates; vertices with several of these become several. An
/// error (invalid_argument) if the mesh has a mistake, or if only some triangles have colors or texture
/// coordinates: such a file cannot say so. Never throws.
GLINT_API Result<std::string> write_ply(const MeshData& mesh);

}  // namespace glint
