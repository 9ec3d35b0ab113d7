// SPDX-License-Identifier: Apache-2.0
#pragma once
// A Scene as a file of glTF 2.0. docs/formats/gltf.md.
#include <string>

#include "glint/result.h"
#include "glint/scene.h"

namespace glint::gltf_export {

/// The bytes of a .glb; its warnings say what is left out or approximated.
Result<std::string> write_binary(const Scene& scene);
/// The text of a .gltf, with its buffer as a data URI.
Result<std::string> write_text(const Scene& scene);

}  // namespace glint::gltf_export
