// SPDX-License-Identifier: Apache-2.0
// sky_sphere: a gradient becomes that of the background.
#include <algorithm>
#include <utility>

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
    both.reserve(2 * colors.size());
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

// { [identifier] pigment ... transforms }, after `sky_sphere`
SkyItems TextureParser::read_sky_items() {
    SkyItems sky;
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return sky;
    while (!failed() && !accept('}')) {
        if (read_transform_item(sky.map)) continue;
        const Token item = peek();
        if (accept(Word::k_pigment)) {
            Pigment pigment = default_texture().pigment;
            read_pigment(pigment);
            sky.pigments.push_back(std::move(pigment));
        } else if (accept(Word::k_emission)) {
            color(true);
        } else if (const Opaque* const named = named_block(item, Word::k_sky_sphere)) {
            take();
            sky = named->sky;
        } else {
            sky.is_known = false;
            skip_rest_of_block();
        }
    }
    return sky;
}

void Reader::read_sky(const Token& at) {
    const SkyItems sky = read_sky_items();
    if (failed()) return;
    scene_.gradient.reset();
    scene_.gradient_place = place_of(at);
    // Each pigment is over those before it.
    std::size_t left = sky.pigments.size();
    while (left > 0 && !scene_.gradient) scene_.gradient = background_of(sky.pigments[--left], sky.map);
    if (!scene_.gradient) {
        builder_.report({"sky_sphere", "other than an opaque gradient", at});
    } else if (left + 1 < sky.pigments.size() || !sky.is_known) {
        builder_.report(
            {"sky_sphere", "beyond an opaque gradient, which is drawn without what is over it", at});
    }
}

}  // namespace glint::povray
