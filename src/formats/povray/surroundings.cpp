// SPDX-License-Identifier: Apache-2.0
// background and fog.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reader.h"
#include "math/number.h"

namespace glint::povray {

void Reader::read_background(const Token& at) {
    if (!expect('{')) return;
    const std::array<double, 5> c = color(true);
    expect('}');
    if (failed()) return;
    background_ = c;
    background_at_ = at;
    scene_.background_place = place_of(at);
    reading().background_given = true;
}

// From version 3.7 on, transmit counts, and a background that is not transparent is part of a picture with
// alpha.
void Reader::use_background(bool is_new) {
    const Color color{background_[0], background_[1], background_[2]};
    const double transmit = is_new ? std::clamp(background_[4], 0.0, 1.0) : 0;
    const bool has_mirrors =
        std::any_of(scene_.materials.begin(), scene_.materials.end(),
                    [](const Material& m) { return m.mirror > 0 || m.mirror_falloff > 0; });
    if (transmit > 0 && !scene_.gradient && has_mirrors &&
        number::max(color.r, number::max(color.g, color.b)) > 0) {
        builder_.report(
            {"transmit", "of the background; mirrors show the background without it", background_at_});
    }
    scene_.background = color * (1 - transmit);
    const double opacity = scene_.gradient ? 1 : reading().background_given ? 1 - transmit : 0;
    if (is_new && opacity > 0) set("background_alpha", version_place_, fmt::format("{}", opacity));
}

// fog { items }: of constant density.
void Reader::read_fog(const Token& at) {
    Fog fog;
    fog.color = {0, 0, 0};
    fog.density = 0;
    if (!expect('{')) return;
    std::optional<Affine> map;
    while (!failed() && !accept('}')) {
        if (accept(',') || read_transform_item(map)) continue;
        const Token item = peek();
        // POV-Ray takes `color` twice here, and only here; color() takes the second one.
        const bool has_word = accept(Word::k_color) || accept(Word::k_colour);
        if (has_word || begins_color(item) || (begins_number(item) && item.kind == TokenKind::word)) {
            const std::array<double, 5> c = color(true);
            fog.color = {c[0], c[1], c[2]};
            fog.transmit = std::clamp(c[4], 0.0, 1.0);
            if (c[3] != 0) builder_.report({"filter", "of a fog", at});
            continue;
        }
        take();
        if (item.word() == Word::k_distance) {
            const double distance = number();
            fog.density = distance > 0 ? 1 / distance : 0;
        } else if (item.word() == Word::k_fog_type) {
            if (number() != 1) builder_.report({"fog_type 2", "fog on the ground", item});
        } else if (item.kind == TokenKind::word && !Names::is_reserved(item.name) && begins_number(peek())) {
            builder_.report({"turbulence", "of a fog", item});
            expression();
        } else {
            error(item, fmt::format("expected `distance`, a color, `fog_type` or `}}`, found {}{}",
                                    describe(item), what_is(item)));
        }
    }
    if (failed() || fog.density == 0) return;
    if (scene_.fog) builder_.report({"fog", "a second one", at});
    scene_.fog = fog;
    scene_.fog_place = place_of(at);
}

}  // namespace glint::povray
