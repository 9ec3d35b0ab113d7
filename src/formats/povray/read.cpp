// SPDX-License-Identifier: Apache-2.0
// The reader's entry: a whole text, from its first statement to the settings that it decides.
#include "formats/povray/reader.h"
#include "formats/povray_keywords.h"
#include "formats/registry.h"

namespace glint {
namespace povray {

void Reader::read() {
    begin();
    if (own_tokens().size() == 1) {
        expected("an object, `camera`, `light_source`, `background` or a directive");
    }
    while (!failed() && peek().kind != TokenKind::end && !reading().diagnostics.full()) read_statement();
    finish();
}

void Reader::read_statement() {
    const Token item = peek();
    if (item.is(';') || item.is(',')) {
        take();
        return;
    }
    if (begins_object(item)) {
        if (!begins_declared(item)) return builder_.place(read_object(), default_texture());
        const ObjectPart object = read_part();
        if (object) builder_.place(*object, default_texture());
        return;
    }
    switch (item.word()) {
        case Word::k_camera:
            take();
            camera_ = read_camera(item);
            return;
        case Word::k_background:
            take();
            return read_background(item);
        case Word::k_global_settings:
            take();
            return read_global_settings();
        case Word::k_fog:
            take();
            return read_fog(item);
        case Word::k_default:  // without `#`
            take();
            return read_default();
        case Word::k_declare:
            take();
            return read_declare(false);
        case Word::k_sky_sphere:
            take();
            return read_sky(item);
        case Word::k_rainbow:
            take();
            skip_block();
            return builder_.report(missing(item, to_string(item.word())));
        default:
            break;
    }
    if (item.kind == TokenKind::word && !Names::is_reserved(item.name)) {
        const std::string_view name = name_of(item.name);
        if (find_value(item) == nullptr && !povray_meaning(name).empty()) {
            take();
            skip_block();
            return builder_.report(missing(item, name));
        }
    }
    expected("an object, `camera`, `light_source`, `background` or a directive");
}

// What the whole text decides.
void Reader::finish() {
    if (failed()) return;
    const bool has_camera = camera_ || default_camera();
    // A text of objects for another scene need not have a camera.
    if (has_camera || !text().is_included) {
        builder_.use_camera(camera_.value_or(default_camera().value_or(CameraItems())));
    }
    if (!has_camera) scene_.camera_place = {};
    if (!(ambient_light_ == Color{0, 0, 0})) {
        Light ambient;
        ambient.kind = LightKind::ambient;
        ambient.color = ambient_light_;
        scene_.light_texts.places.resize(scene_.lights.size());
        scene_.light_texts.places.emplace_back();
        scene_.lights.push_back(ambient);
    }
    const bool is_new = version_.value_or(0) >= 3.7;
    use_background(is_new);
    builder_.finish(camera_ ? camera_->at : own_tokens().front());
    use_gamma();
    if (!is_new) set("opacity", version_place_, "brightest");
    set("rounding", version_place_, "half_up");
}

}  // namespace povray

/// POV-Ray's default camera looks along +z.
void set_povray_defaults(Scene& scene) {
    scene.camera.position = {0, 0, 0};
    scene.camera.look_at = {0, 0, 1};
    scene.camera.frame = CameraFrame{{povray::k_default_right, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    scene.background = {0, 0, 0};
}

void read_povray(LoadState& reading, const ReadText& text) { povray::Reader(reading, text).read(); }

}  // namespace glint
