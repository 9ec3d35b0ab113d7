// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scene to text.
#include <span>
#include <string>

#include "glint/export.h"
#include "glint/load.h"
#include "glint/result.h"
#include "glint/scene.h"

namespace glint {

/// The scene in glint's own language (docs/formats/glint.md), for people to read and edit: load() makes of it
/// a scene that draws the same picture to the bit. Numbers are as short as they can be and still the same.
/// texts: what the scene was read from, the included ones too, each under the name that Scene::files has;
/// their comments are kept beside the items that they stand by. An error if validate() finds one in the
/// scene. Never throws; the time and memory are proportional to the scene and the texts.
GLINT_API Result<std::string> write_glint(const Scene& scene, std::span<const SceneText> texts = {});

}  // namespace glint
