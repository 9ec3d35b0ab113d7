// SPDX-License-Identifier: Apache-2.0
// camera { } of glint's own language.
#include <fmt/format.h>

#include "formats/glint_text.h"

namespace glint {
namespace {

enum {
    k_projection,
    k_position,
    k_look_at,
    k_up,
    k_fov_x,
    k_fov_y,
    k_width,
    k_lighting_eye,
    k_right,
    k_forward
};
constexpr Field k_fields[] = {{"projection"}, {"position"}, {"look_at"},      {"up"},    {"fov_x"},
                              {"fov_y"},      {"width"},    {"lighting_eye"}, {"right"}, {"forward"}};

constexpr std::string_view k_fov =
    "`fov_x` (across the picture's width) or `fov_y` (across its height), in degrees";
constexpr SpellingHint k_hints[] = {{"fov", k_fov},
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

// What does not go together. Each mistake is named at the block.
void check(GlintText& t, const FieldSet& set, const Token& word, const Camera& camera) {
    const bool is_flat = camera.projection == Projection::orthographic;
    if (set.has(k_right) || set.has(k_forward)) {
        if (!set.has(k_right) || !set.has(k_up) || !set.has(k_forward))
            t.p.error(word, "expected `right`, `up` and `forward`, all three or none of them");
        for (const int field : {k_look_at, k_fov_x, k_fov_y, k_width}) {
            if (!set.has(field)) continue;
            t.p.error(word,
                      fmt::format("expected no `{}` beside `right`, `up` and `forward`, which say it already",
                                  k_fields[field].name));
        }
        return;
    }
    if (set.has(k_fov_x) && set.has(k_fov_y)) t.p.error(word, "expected `fov_x` or `fov_y`, found both");
    if (is_flat && (set.has(k_fov_x) || set.has(k_fov_y)))
        t.p.error(word, "an orthographic camera has no field of view: write `width`");
    if (!is_flat && set.has(k_width))
        t.p.error(word,
                  "a perspective camera has no `width`: write `fov_x` or `fov_y`, or "
                  "`projection = orthographic`");
}

}  // namespace

void read_glint_camera(GlintText& t, const Token& word) {
    FieldSet set("camera", k_fields, k_hints);
    Camera camera;
    CameraFrame frame;
    const bool whole = t.blocks.fields(set, word, [&](int field, const Token&) {
        switch (field) {
            case k_projection: {
                static constexpr std::string_view words[] = {"perspective", "orthographic"};
                int index = 0;
                if (!t.p.choice(words, "`perspective` or `orthographic`", index)) return false;
                camera.projection = static_cast<Projection>(index);
                return true;
            }
            case k_position:
                return read_point(t, camera.position);
            case k_look_at:
                return read_point(t, camera.look_at);
            case k_up:
                return read_direction(t, camera.up);
            case k_fov_x:
            case k_fov_y:
                camera.fov_axis = field == k_fov_x ? FovAxis::x : FovAxis::y;
                return t.p.number(camera.fov_degrees, k_angle);
            case k_width:
                return t.p.number(camera.width, k_length);
            case k_lighting_eye:
                return read_point(t, camera.lighting_eye.emplace());
            case k_right:
                return read_direction(t, frame.right);
            default:
                return read_direction(t, frame.forward);
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
