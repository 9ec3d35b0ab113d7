// SPDX-License-Identifier: Apache-2.0
// The reader's entry: a whole text, from its first statement to the settings that it decides.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reader.h"
#include "formats/registry.h"

namespace glint {
namespace povray {

Reader::Reader(LoadState& reading, const ReadText& text)
    : reading_(reading), scene_(reading.scene), text_(text) {}

void Reader::read() {
    lex_text(text_.file);
    max_steps_ = k_max_steps + tokens_[text_.file].size();
    Frame frame;
    frame.text = text_.file;
    frame.tokens = tokens_[text_.file].data();
    frame.end = static_cast<std::uint32_t>(tokens_[text_.file].size() - 1);
    frames_.push_back(std::move(frame));
    declare_numbers();
    if (tokens_[text_.file].size() == 1 && lex_errors_[text_.file].message.empty()) {
        expected("an object, `camera`, `light_source`, `background` or a directive");
    }
    while (!failed_ && peek().kind != TokenKind::end && !reading_.diagnostics.full()) read_statement();
    finish_settings();
}

// What the caller declares.
void Reader::declare_numbers() {
    for (const auto& [name, value] : reading_.options.declared) {
        const std::uint32_t number = names_.number_of(name);
        if (Names::is_reserved(number)) continue;
        if (bindings_.size() < names_.size()) bindings_.resize(names_.size());
        bind(number, 0, Numbers(value));
    }
}

std::optional<double> Reader::clock() const { return declared_number("clock"); }

std::optional<double> Reader::declared_number(std::string_view wanted) const {
    std::optional<double> number;
    for (const auto& [name, value] : reading_.options.declared) {
        if (name == wanted) number = value;
    }
    return number;
}

// The size of the picture: the command's, else that of the profile.
RenderSettings Reader::scene_size(const Token&) {
    Scene sized;
    sized.settings = scene_.settings;
    const auto key = find_setting("size");
    for (const auto& [name, value] : reading_.options.settings) {
        if (key && name == "size") (void)set_setting(sized, *key, value, {}).ok();
    }
    return sized.settings;
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
