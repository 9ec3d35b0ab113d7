// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "formats/povray/object.h"

namespace glint::povray {

/// The most triangles that facing_outwards() turns: it takes a time in proportion to their square.
inline constexpr std::size_t k_max_turned_faces = 3000;

/// The mesh with the triangles turned that faced inwards, so that their vertices are counterclockwise seen
/// from outside. Null if it encloses no space. At most k_max_turned_faces triangles.
std::shared_ptr<const ReadMesh> facing_outwards(const ReadMesh& mesh);

}  // namespace glint::povray
