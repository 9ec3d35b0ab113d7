// SPDX-License-Identifier: Apache-2.0
// sky_sphere: a gradient of two colors becomes the scene's background gradient.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reader.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr std::size_t k_max_map = 256;  // entries of a color_map; POV-Ray's limit
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

// Nothing if the engine's gradient, of two colors, is not the same.
std::optional<BackgroundGradient> background_of(const Pigment& pigment, const std::optional<Affine>& sky) {
    BackgroundGradient out;
    if (!pigment.missing) {
        if (!is_opaque_color(pigment.color)) return std::nullopt;
        out.bottom_color = out.top_color = rgb_of(pigment.color);
        return out;
    }
    if (!pigment.gradient || pigment.gradient->map.size() != 2) return std::nullopt;
    const ColorMapEntry &low = pigment.gradient->map[0], &high = pigment.gradient->map[1];
    const auto line = along(*pigment.gradient, sky);
    if (!line || !is_opaque_color(low.color) || !is_opaque_color(high.color) || !(low.at < high.at)) {
        return std::nullopt;
    }
    const double least = line->start - line->size, most = line->start + line->size;
    const bool is_one_period = least >= -k_same_place && most <= 1 + k_same_place;
    const bool is_whole = number::abs(low.at) <= k_same_place && number::abs(high.at - 1) <= k_same_place;
    if (!is_one_period && !is_whole) return std::nullopt;
    out.up = line->up;
    out.bottom = (low.at - line->start) / line->size;
    out.top = (high.at - line->start) / line->size;
    if (!(number::abs(out.bottom) < k_far && number::abs(out.top) < k_far)) return std::nullopt;
    out.bottom_color = rgb_of(low.color);
    out.top_color = rgb_of(high.color);
    out.repeats = !is_one_period;
    return out;
}

}  // namespace

// sky_sphere { pigment ... transforms }
void Reader::read_sky(const Token& at) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    std::optional<Affine> map;
    std::optional<Pigment> pigment;
    bool is_one = true;
    while (!failed_ && !accept('}')) {
        if (read_transform_item(map)) continue;
        if (accept(Word::k_pigment)) {
            is_one = is_one && !pigment;
            pigment = default_texture_.pigment;
            read_pigment(*pigment);
        } else if (accept(Word::k_emission)) {
            color(true);
        } else {
            is_one = false;  // the name of another sky
            skip_rest();
        }
    }
    if (failed_) return;
    scene_.gradient.reset();
    if (pigment && is_one) scene_.gradient = background_of(*pigment, map);
    scene_.gradient_place = place_of(at);
    if (!scene_.gradient) report({"sky_sphere", "other than a gradient of two colors", at});
}

// VECTOR items, after `gradient`: null for items that a sky cannot have. The rest of the block is read.
std::shared_ptr<const GradientPattern> Reader::read_gradient(std::optional<Affine> map) {
    auto gradient = make_counted<GradientPattern>();
    const Token at = peek();
    gradient->axis = vector();
    if (!failed_ && gradient->axis == Vec3{0, 0, 0}) error(at, "expected a gradient other than 0");
    gradient->axis = normalize(gradient->axis);  // its length does not count in POV-Ray
    bool is_known = true;
    while (!failed_ && !peek().is('}')) {
        if (read_transform_item(map)) continue;
        if (accept(Word::k_color_map) || accept(Word::k_colour_map)) {
            is_known = read_color_map(gradient->map) && is_known;
        } else {
            is_known = false;
            skip_rest();
        }
    }
    gradient->transform = map;
    return is_known ? gradient : nullptr;
}

// { [number color] ... }; also [number number color color]. False if the map is the name of one.
bool Reader::read_color_map(CountedVector<ColorMapEntry>& map) {
    if (!expect('{')) return false;
    while (!failed_ && !accept('}')) {
        const Token at = peek();
        if (!at.is('[')) {
            skip_rest();
            continue;
        }
        take();
        ColorMapEntry entry{number(), {}};
        std::optional<double> second;
        accept(',');
        const Numbers next = begins_color(peek()) ? color_value() : expression();
        if (next.terms == 1) {
            second = next.v[0];
            accept(',');
            entry.color = color(true);
        } else {
            entry.color = promoted(next, 5).v;
        }
        map.push_back(entry);
        accept(',');
        if (second) map.push_back({*second, color(true)});
        expect(']');
        accept(',');
        if (map.size() > k_max_map) error(at, fmt::format("expected at most {} entries", k_max_map));
    }
    return !failed_ && !map.empty();
}

}  // namespace glint::povray
