// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checks that the triangles of a mesh are valid.
#include <string>

#include "glint/mesh.h"

namespace glint {

/// The first mistake in a mesh, with the number of the triangle or vertex; empty: there is none.
std::string mistake_in(const MeshData& mesh);

}  // namespace glint
