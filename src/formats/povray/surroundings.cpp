// SPDX-License-Identifier: Apache-2.0
// background, fog and sky_sphere: a gradient becomes that of the background.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reader.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr double k_same_place = 1e-9, k_far = 1e6;

bool is_opaque_color(const std::array<double, 5>& c) { return c[3] == 0 && c[4] == 0; }

// The direction d of a ray is at x = size (d · up / |up|) + start of the pattern.
struct Along {
    Vec3 up;
    double size = 0, start = 0;
};

std::optional<Along> along(const GradientPattern& gradient, const std::optional<Affine>& sky) {
    std::optional<Affine> map = gradient.transform;
    if (sky) map = map ? compose(*sky, *map) : *sky;
    Along out{gradient.axis};
    if (map) {
        const auto back = inverse(*map);
        if (!back) return std::nullopt;
        const Vec3 o = transform_point(*back, {0, 0, 0});
        const auto part = [&](Vec3 unit) { return dot(gradient.axis, transform_vector(*back, unit)); };
        out = {{part({1, 0, 0}), part({0, 1, 0}), part({0, 0, 1})}, 0, dot(gradient.axis, o)};
    }
    out.size = length(out.up);
    if (!(out.size > 1e-6 && out.size < 1e6)) return std::nullopt;
    return out;
}

// Of the pattern `planar`, 1 - |x|, as a gradient from x = -1 to x = 1.
std::vector<TextureColor> both_sides(const std::vector<TextureColor>& colors) {
    std::vector<TextureColor> both;
    for (const TextureColor& c : colors) both.push_back({c.at / 2, c.color});
    for (std::size_t i = colors.size(); i-- > 0;) both.push_back({1 - colors[i].at / 2, colors[i].color});
    return both;
}

// A map of colors along a line; nothing if it is transparent or too fine.
std::optional<BackgroundGradient> gradient_along(const Along& line, std::vector<TextureColor> colors,
                                                 double bottom, double top) {
    BackgroundGradient out;
    out.up = line.up;
    out.bottom = (bottom - line.start) / line.size;
    out.top = (top - line.start) / line.size;
    if (!(number::abs(out.bottom) < k_far && number::abs(out.top) < k_far)) return std::nullopt;
    const bool is_opaque =
        std::all_of(colors.begin(), colors.end(), [](const TextureColor& c) { return c.alpha == 1; });
    if (!is_opaque || colors.size() > k_max_texture_colors) return std::nullopt;
    out.color_map = std::move(colors);
    return out;
}

// Nothing if the engine has no such background.
std::optional<BackgroundGradient> background_of(const Pigment& pigment, const std::optional<Affine>& sky) {
    BackgroundGradient out;
    const bool is_planar =
        pigment.image && pigment.image->mapping == TextureMapping::slabs && !pigment.missing;
    if (is_planar) {
        const auto line = along({{0, 1, 0}, {}, pigment.map}, sky);
        return line ? gradient_along(*line, both_sides(pigment.image->color_map), -1, 1) : std::nullopt;
    }
    if (pigment.image && !pigment.gradient) return std::nullopt;
    if (!pigment.missing && !pigment.gradient) {
        if (!is_opaque_color(pigment.color)) return std::nullopt;
        out.bottom_color = out.top_color = rgb_of(pigment.color);
        return out;
    }
    if (!pigment.gradient || !pigment.image) return std::nullopt;
    const auto line = along(*pigment.gradient, sky);
    if (!line) return std::nullopt;
    const double least = line->start - line->size, most = line->start + line->size;
    const bool is_one_period = least >= -k_same_place && most <= 1 + k_same_place;
    if (pigment.gradient->map.size() == 2) {
        const ColorMapEntry &low = pigment.gradient->map[0], &high = pigment.gradient->map[1];
        const bool is_whole = number::abs(low.at) <= k_same_place && number::abs(high.at - 1) <= k_same_place;
        if (is_opaque_color(low.color) && is_opaque_color(high.color) && low.at < high.at &&
            (is_one_period || is_whole)) {
            out.up = line->up;
            out.bottom = (low.at - line->start) / line->size;
            out.top = (high.at - line->start) / line->size;
            if (!(number::abs(out.bottom) < k_far && number::abs(out.top) < k_far)) return std::nullopt;
            out.bottom_color = rgb_of(low.color);
            out.top_color = rgb_of(high.color);
            out.repeats = !is_one_period;
            return out;
        }
    }
    auto whole = gradient_along(*line, pigment.image->color_map, 0, 1);
    if (whole) whole->repeats = !is_one_period;
    return whole;
}

}  // namespace

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

// sky_sphere { pigment ... transforms }
void Reader::read_sky(const Token& at) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    std::optional<Affine> map;
    std::optional<Pigment> pigment;
    bool is_one = true;
    while (!failed() && !accept('}')) {
        if (read_transform_item(map)) continue;
        if (accept(Word::k_pigment)) {
            is_one = is_one && !pigment;
            pigment = default_texture().pigment;
            read_pigment(*pigment);
        } else if (accept(Word::k_emission)) {
            color(true);
        } else {
            is_one = false;  // the name of another sky
            skip_rest();
        }
    }
    if (failed()) return;
    scene_.gradient.reset();
    if (pigment && is_one) scene_.gradient = background_of(*pigment, map);
    scene_.gradient_place = place_of(at);
    if (!scene_.gradient) builder_.report({"sky_sphere", "other than an opaque gradient", at});
}

}  // namespace glint::povray
