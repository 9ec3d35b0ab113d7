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

/// The scene in glint's own language (docs/formats/glint.md), for people to read and edit. load() reads it
/// back as a scene that renders to the same bits. Numbers are the shortest that read back as the same double.
/// texts: the texts that the scene was read from, included ones too, each under its name in Scene::files;
/// their comments are kept with their items. An error if validate() finds one in the scene. Never throws.
/// Time and memory are proportional to the scene and the texts.
GLINT_API Result<std::string> write_glint(const Scene& scene, std::span<const SceneText> texts = {});

}  // namespace glint
