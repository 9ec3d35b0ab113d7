// SPDX-License-Identifier: Apache-2.0
// camera { } of glint's own language.
#include <fmt/format.h>

#include "formats/field_keys.h"
#include "formats/glint_blocks.h"
#include "scene/camera_fields.h"

namespace glint {
namespace {

// The keys: three that are not fields of the camera, then the fields.
enum { k_projection, k_right, k_forward };
const FieldKeys<Camera>& camera_keys() {
    static const FieldKeys<Camera> keys({{"projection"}, {"right"}, {"forward"}}, k_camera_fields);
    return keys;
}

constexpr std::string_view k_fov =
    "`fov_x` (across the picture's width) or `fov_y` (across its height), in degrees";
constexpr SpellingHint k_camera_hints[] = {
    {"fov", k_fov},
    {"fov_degrees", k_fov},
    {"angle", k_fov},
    {"field_of_view", k_fov},
    {"target", "`look_at`"},
    {"lookat", "`look_at`"},
    {"look", "`look_at`"},
    {"at", "`look_at`"},
    {"to", "`look_at`"},
    {"direction", "`look_at`, a point; or `right`, `up` and `forward`"},
    {"rotation", "`right`, `up` and `forward`"},
    {"eye", "`position`"},
    {"from", "`position`"},
    {"location", "`position`"},
    {"type", "`projection`"},
    {"viewer", "`lighting_eye`"},
    {"observer", "`lighting_eye`"}};

// Reports keys that exclude each other, at the block.
void check(GlintText& t, const FieldSet& set, const Token& word, const Camera& camera) {
    const FieldKeys<Camera>& keys = camera_keys();
    const int look_at = keys.key_of(&Camera::look_at), up = keys.key_of(&Camera::up),
              fov_x = keys.key_of(&Camera::fov_degrees), fov_y = fov_x + 1,
              width = keys.key_of(&Camera::width);
    const bool is_flat = camera.projection == Projection::orthographic;
    if (set.has(k_right) || set.has(k_forward)) {
        if (!set.has(k_right) || !set.has(up) || !set.has(k_forward))
            t.p.error(word, "expected `right`, `up` and `forward`, all three or none of them");
        for (const int key : {look_at, fov_x, fov_y, width}) {
            if (!set.has(key)) continue;
            t.p.error(word,
                      fmt::format("expected no `{}` beside `right`, `up` and `forward`, which say it already",
                                  set.fields()[static_cast<std::size_t>(key)].name));
        }
        return;
    }
    if (set.has(fov_x) && set.has(fov_y)) t.p.error(word, "expected `fov_x` or `fov_y`, found both");
    if (is_flat && (set.has(fov_x) || set.has(fov_y)))
        t.p.error(word, "an orthographic camera has no field of view: write `width`");
    if (!is_flat && set.has(width))
        t.p.error(word,
                  "a perspective camera has no `width`: write `fov_x` or `fov_y`, or "
                  "`projection = orthographic`");
}

}  // namespace

std::span<const Field> glint_camera_keys() { return camera_keys().all(); }

void read_glint_camera(GlintText& t, const Token& word) {
    const FieldKeys<Camera>& keys = camera_keys();
    const int fov_x = keys.key_of(&Camera::fov_degrees), fov_y = fov_x + 1;
    FieldSet set("camera", keys.all(), k_camera_hints);
    Camera camera;
    CameraFrame frame;
    const bool whole = t.blocks.fields(set, word, [&](int key, const Token&) {
        switch (key) {
            case k_projection: {
                static constexpr std::string_view words[] = {"perspective", "orthographic"};
                int index = 0;
                if (!t.p.choice(words, one_of(words), index)) return false;
                camera.projection = static_cast<Projection>(index);
                return true;
            }
            case k_right:
                return read_direction(t, frame.right);
            case k_forward:
                return read_direction(t, frame.forward);
            default:
                if (key == fov_x || key == fov_y) camera.fov_axis = key == fov_x ? FovAxis::x : FovAxis::y;
                return read_field(t, *keys.field(key), camera);
        }
    });
    if (!whole) return;
    check(t, set, word, camera);
    if (set.has(k_right)) {
        frame.up = camera.up;
        camera.frame = frame;
    }
    LoadState& reading = t.reading;
    if (reading.camera_given) {
        t.p.warn(word, reading.camera_included ? "this camera holds, and not that of an included file"
                                               : "a second camera: the last one holds");
    }
    reading.camera_given = true;
    reading.camera_included = false;
    t.scene.camera = camera;
    t.scene.camera_place = source_place(t.text, word);
}

}  // namespace glint
