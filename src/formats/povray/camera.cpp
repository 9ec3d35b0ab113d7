// SPDX-License-Identifier: Apache-2.0
// The camera: its items are collected.
#include <fmt/format.h>

#include "formats/povray/object_parser.h"

namespace glint::povray {

// { [identifier] items }
CameraItems ObjectParser::read_camera(const Token& word) {
    CameraItems camera = default_camera_.value_or(CameraItems());
    camera.at = word;
    if (!expect('{')) return camera;
    while (!failed() && !accept('}')) {
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

}  // namespace glint::povray
