// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "glint/scene.h"
#include "world/world.h"

namespace glint {

/// The viewport's frame for the picture's size; right and up have the viewport's full width and height.
PreparedCamera prepare_camera(const Camera& camera, const RenderSettings& settings);

}  // namespace glint
