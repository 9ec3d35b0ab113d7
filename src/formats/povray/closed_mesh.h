// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "formats/povray/object.h"

namespace glint::povray {

/// The mesh as an operand of a solid: with its triangles split where vertices of others lie on their edges,
/// as those of a prism's caps do, and turned so that neighbours face the same side. The mesh itself if
/// nothing of that is needed, or if it has very many parts. Null if it encloses no space, or if finding out
/// takes too long. It is found once for each mesh.
std::shared_ptr<const ReadMesh> closed_mesh(const std::shared_ptr<const ReadMesh>& mesh);

/// The same, if all its triangles face outwards, else null.
std::shared_ptr<const ReadMesh> outward_mesh(const std::shared_ptr<const ReadMesh>& mesh);

}  // namespace glint::povray
