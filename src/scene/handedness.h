// SPDX-License-Identifier: Apache-2.0
#pragma once
// Left and right of a camera in glint and in POV-Ray.
#include "glint/scene.h"

namespace glint {

/// Whether POV-Ray, which computes the right vector from `look_at`, has it on the other side.
inline bool is_reversed_in_povray(const CameraFrame& frame) {
    const Vec3 across = cross(Vec3{0, 1, 0}, frame.forward);
    const bool mirrored = dot(cross(frame.up, Vec3{0, 0, 1}), frame.right) <= 0;
    return dot(mirrored ? -across : across, frame.right) < 0;
}

}  // namespace glint
