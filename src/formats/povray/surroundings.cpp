// SPDX-License-Identifier: Apache-2.0
// background and fog.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reader.h"
#include "math/number.h"
#include "math/transform.h"

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
                    [](const Material& m) { return m.mirror > 0 || m.has_angled_mirror(); });
    if (transmit > 0 && !scene_.gradient && has_mirrors &&
        number::max(color.r, number::max(color.g, color.b)) > 0) {
        builder_.report(
            {"transmit", "of the background; mirrors show the background without it", background_at_});
    }
    scene_.background = color * (1 - transmit);
    const double opacity = scene_.gradient ? 1 : reading().background_given ? 1 - transmit : 0;
    if (is_new && opacity > 0) set("background_alpha", version_place_, fmt::format("{}", opacity));
}

// The least fog_alt that is drawn.
constexpr double k_least_fog_alt = 1e-6;

// fog { items }
void Reader::read_fog(const Token& at) {
    Fog fog;
    fog.color = {0, 0, 0};
    fog.density = 0;
    if (!expect('{')) return;
    double alt = 0;
    std::optional<Token> ground;
    while (!failed() && !accept('}')) {
        std::optional<Affine> map;
        if (accept(',')) continue;
        if (read_transform_item(map)) {
            if (map) fog.up = transform_vector(*map, fog.up);  // nothing else moves (measured)
            continue;
        }
        const Token item = peek();
        const std::string_view word = item.kind == TokenKind::word ? text_of(item) : std::string_view();
        // POV-Ray takes `color` twice here, and only here; color() takes the second one.
        const bool has_word = accept(Word::k_color) || accept(Word::k_colour);
        if (has_word || begins_color(item) || (begins_number(item) && item.kind == TokenKind::word)) {
            const std::array<double, 5> c = color(true);
            fog.color = {c[0], c[1], c[2]};
            fog.transmit = std::clamp(c[4], 0.0, 1.0);
            fog.filter = std::clamp(c[3], 0.0, 1.0);
            if (fog.filter != c[3]) builder_.report({"filter", "of a fog, beyond 0 and 1", at});
            continue;
        }
        take();
        if (item.word() == Word::k_distance) {
            const double distance = number();
            fog.density = distance > 0 ? 1 / distance : 0;
        } else if (item.word() == Word::k_fog_type) {
            ground.reset();
            if (number() == 2) ground = item;
        } else if (item.word() == Word::k_up) {
            fog.up = vector();
        } else if (word == "fog_offset" || word == "fog_alt") {
            (word == "fog_alt" ? alt : fog.height) = number();
        } else if (item.kind == TokenKind::word && !Names::is_reserved(item.name) && begins_number(peek())) {
            builder_.report({"turbulence", "of a fog", item});
            expression();
        } else {
            error(item, fmt::format("expected `distance`, a color, `fog_type` or `}}`, found {}{}",
                                    describe(item), what_is(item)));
        }
    }
    if (failed() || fog.density == 0) return;
    if (ground) {
        if (!(alt > 0)) builder_.report({"fog_alt", "that is not above 0: the fog ends sharply", *ground});
        fog.falloff = number::max(alt, k_least_fog_alt);
    } else {
        fog.height = 0;
    }
    if (!ground || fog.up == Vec3{0, 0, 0}) fog.up = {0, 1, 0};
    if (fog.filter > 0 && fog.transmit == 1) builder_.report({"filter", "of a fog with a transmit of 1", at});
    if (scene_.fog) builder_.report({"fog", "a second one", at});
    scene_.fog = fog;
    scene_.fog_place = place_of(at);
}

}  // namespace glint::povray
