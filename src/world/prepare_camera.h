// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "glint/scene.h"
#include "world/world.h"

namespace glint {

/// The viewport's frame, in full widths and heights, for the picture's size.
PreparedCamera prepare_camera(const Camera& camera, const RenderSettings& settings);

}  // namespace glint
