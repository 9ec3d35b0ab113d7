// SPDX-License-Identifier: Apache-2.0
#include "world/prepare_camera.h"

#include "math/elementary.h"
#include "math/transform.h"

namespace glint {

PreparedCamera prepare_camera(const Camera& camera, const RenderSettings& settings) {
    PreparedCamera out;
    out.projection = camera.projection;
    out.position = camera.position;
    out.has_lighting_eye = camera.lighting_eye.has_value();
    if (camera.lighting_eye) out.lighting_eye = *camera.lighting_eye;
    if (camera.frame) {
        out.right = camera.frame->right;
        out.up = camera.frame->up;
        out.forward = camera.frame->forward;
        return out;
    }
    const Vec3 forward = normalize(camera.look_at - camera.position);
    const Vec3 x = normalize(cross(forward, camera.up));
    const Vec3 y = cross(x, forward);
    const double aspect = static_cast<double>(settings.width) / settings.height;
    double width = camera.width;
    if (camera.projection == Projection::perspective) {
        width = 2 * tan_degrees(camera.fov_degrees / 2);
        if (camera.fov_axis == FovAxis::y) width = width * aspect;
    }
    out.right = x * width;
    out.up = y * (width / aspect);
    out.forward = forward;
    return out;
}

}  // namespace glint
