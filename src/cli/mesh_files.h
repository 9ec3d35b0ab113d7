// SPDX-License-Identifier: Apache-2.0
#pragma once
// The files of the meshes of a scene that is written.
#include <string>
#include <vector>

#include "glint/scene.h"

namespace glint::cli {

/// By mesh: the name of its file, relative to the folder of `output`, a .glint file; empty: none. Meshes of
/// files keep theirs; larger ones of the scene's texts are written beside the output, as scene-1.ply,
/// scene-2.ply ... for scene.glint. Throws Failure.
std::vector<std::string> write_mesh_files(const Scene& scene, const std::string& output);

}  // namespace glint::cli
