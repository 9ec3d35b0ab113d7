// SPDX-License-Identifier: Apache-2.0
#pragma once
// The files of the meshes and textures of a scene that is written.
#include <string>
#include <vector>

#include "cli/output_file.h"
#include "glint/scene.h"

namespace glint::cli {

/// By mesh: the name of its file, relative to the folder of the output, a .glint file; empty: none. Meshes
/// of files keep theirs; larger ones of the scene's texts are written beside the output, as scene-1.ply,
/// scene-2.ply ... for scene.glint, which replace only those of an earlier conversion. format: as the user
/// gives it; empty: by the names of files. Throws Failure.
std::vector<std::string> write_mesh_files(const Scene& scene, const std::string& format,
                                          const OutputFile& output);

/// The same for a text that is printed: nothing is written, and names are relative to the present folder.
std::vector<std::string> known_mesh_files(const Scene& scene, const std::string& format);

/// Makes the names of the textures' files relative to the folder of the output, too.
void name_texture_files(Scene& scene, const OutputFile& output);

}  // namespace glint::cli
