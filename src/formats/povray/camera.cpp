// SPDX-License-Identifier: Apache-2.0
// The camera: its items are collected, and applied together at the closing brace.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reader.h"
#include "formats/povray_keywords.h"
#include "math/elementary.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {

// { [identifier] items }
CameraItems Reader::read_camera(const Token& word) {
    CameraItems camera = camera_default_.value_or(CameraItems());
    camera.at = word;
    if (!expect('{')) return camera;
    while (!failed_ && !accept('}')) {
        if (accept(',') || read_transform_item(camera.map)) continue;
        const Token item = take();
        switch (item.word()) {
            case Word::k_perspective:
                camera.is_orthographic = false;
                break;
            case Word::k_orthographic:
                camera.is_orthographic = true;
                break;
            case Word::k_location:
                camera.location = vector();
                break;
            case Word::k_direction:
                camera.direction = vector();
                break;
            case Word::k_up:
                camera.up = vector();
                camera.has_up = true;
                break;
            case Word::k_right:
                camera.right = vector();
                camera.has_right = true;
                break;
            case Word::k_sky:
                camera.sky = vector();
                break;
            case Word::k_look_at:
                camera.look_at = vector();
                break;
            case Word::k_angle:
                camera.angle = number();
                camera.has_angle = true;
                if (accept(',')) number();
                break;
            case Word::k_focal_point:
                vector();
                break;
            case Word::k_aperture:
                if (number() != 0) camera.missing.add(missing(item, "aperture"));
                break;
            case Word::k_blur_samples:
                number();
                while (accept(',')) number();
                break;
            case Word::k_confidence:
            case Word::k_variance:
                number();
                break;
            case Word::k_fisheye:
            case Word::k_omnimax:
            case Word::k_panoramic:
            case Word::k_spherical:
            case Word::k_ultra_wide_angle:
            case Word::k_cylinder:
                camera.missing.add({to_string(item.word()), "a kind of camera", item, true});
                if (item.word() == Word::k_cylinder) number();
                break;
            case Word::k_normal:
                skip_block();
                camera.missing.add(missing(item, "normal"));
                break;
            default: {
                if (const auto held = named<CameraItems>(item)) {
                    camera = *held;
                } else {
                    error(item, fmt::format("expected an item of a camera or `}}`, found {}{}",
                                            describe(item), what_is(item)));
                }
            }
        }
    }
    camera.at = word;
    return camera;
}

// POV-Ray's order: angle, look_at, the size of orthographic cameras, transforms.
void Reader::use_camera(const CameraItems& items) {
    report(items.missing);
    if (items.missing.has_error()) return;
    Vec3 location = items.location, direction = items.direction, up = items.up, right = items.right;
    if (items.angle > 0) {
        const bool is_wide = items.angle >= 180 && !items.is_orthographic;
        if (is_wide) return error(items.at, "expected an angle below 180 degrees");
        direction = normalize(direction) * (0.5 * length(right) / tan_degrees(items.angle / 2));
    }
    if (items.look_at) {
        const double focal = length(direction), width = length(right), height = length(up);
        const bool is_mirrored = dot(cross(up, direction), right) <= 0;
        const Vec3 to = *items.look_at - location;
        if (to == Vec3{0, 0, 0}) return error(items.at, "expected a `look_at` other than the location");
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
    scene_.camera_place = place_of(items.at);
    reading_.camera_given = true;
}

}  // namespace glint::povray
