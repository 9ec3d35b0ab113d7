// SPDX-License-Identifier: Apache-2.0
#pragma once
// prepare() of scenes that load_validated() has read.
#include "glint/world.h"
#include "scene/validated_scene.h"

namespace glint {

/// As the public prepare(), without validating again. The diagnostics are the scene's warnings. Never throws.
Result<World> prepare(const ValidatedScene& scene, const PrepareOptions& options = {});

}  // namespace glint
