// SPDX-License-Identifier: Apache-2.0
#pragma once
// The place of a node.
#include "export/gltf/file.h"
#include "glint/vec.h"

namespace glint::gltf_export {

/// Whether a node may have this map: a translation, a rotation and a scale that is not 0.
bool is_placement(const Affine& map);

/// Adds the map to a node: `translation` and `scale` without a rotation, else a `matrix`.
void add_placement(Json& node, const Affine& map);

}  // namespace glint::gltf_export
