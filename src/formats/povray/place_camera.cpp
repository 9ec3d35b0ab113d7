// SPDX-License-Identifier: Apache-2.0
// The camera's items to that of the Scene.
#include <algorithm>

#include "formats/povray/scene_builder.h"
#include "math/elementary.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {

// POV-Ray's order: angle, look_at, the size of orthographic cameras, transforms.
void SceneBuilder::use_camera(const CameraItems& items) {
    report(items.missing);
    if (items.missing.has_error()) return;
    Vec3 location = items.location, direction = items.direction, up = items.up, right = items.right;
    if (items.angle > 0) {
        const bool is_wide = items.angle >= 180 && !items.is_orthographic;
        if (is_wide) return stream_.error(items.at, "expected an angle below 180 degrees");
        direction = normalize(direction) * (0.5 * length(right) / tan_degrees(items.angle / 2));
    }
    if (items.look_at) {
        const double focal = length(direction), width = length(right), height = length(up);
        const bool is_mirrored = dot(cross(up, direction), right) <= 0;
        const Vec3 to = *items.look_at - location;
        if (to == Vec3{0, 0, 0})
            return stream_.error(items.at, "expected a `look_at` other than the location");
        direction = normalize(to) * focal;
        const Vec3 across = cross(items.sky, normalize(to));
        const double most = std::max({number::abs(across.x), number::abs(across.y), number::abs(across.z)});
        // Along `sky` the camera keeps its own right vector.
        right = normalize(most < 1e-10 ? right : across) * width;
        up = normalize(cross(direction, right)) * height;
        if (is_mirrored) right = -right;
        if (items.is_orthographic && ((!items.has_up && !items.has_right) || items.has_angle)) {
            const double factor = length(to) / focal;
            right = right * factor;
            up = up * factor;
        }
    }
    if (items.map) {
        location = transform_point(*items.map, location);
        direction = transform_vector(*items.map, direction);
        up = transform_vector(*items.map, up);
        right = transform_vector(*items.map, right);
    }
    Camera camera;
    camera.projection = items.is_orthographic ? Projection::orthographic : Projection::perspective;
    camera.position = location;
    camera.look_at = location + direction;
    camera.frame = CameraFrame{right, up, direction};
    scene_.camera = camera;
    scene_.camera_place = stream_.place_of(items.at);
    reading_.camera_given = true;
}

}  // namespace glint::povray
