// SPDX-License-Identifier: Apache-2.0
#pragma once
// load() for callers that prepare the scene as it was read.
#include "glint/load.h"
#include "scene/validated_scene.h"

namespace glint {

/// As load(). Never throws.
Result<ValidatedScene> load_validated(std::span<const SceneText> texts, const LoadOptions& options = {},
                                      Sources* sources = nullptr);

}  // namespace glint
