// SPDX-License-Identifier: Apache-2.0
// The pattern `gradient` and its map of colors.
#include <fmt/format.h>

#include "formats/povray/texture_parser.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr std::size_t k_max_map = 256;  // entries of a color_map; POV-Ray's limit

}  // namespace

// VECTOR items, after `gradient`: null for items that a sky cannot have. The rest of the block is read.
std::shared_ptr<const GradientPattern> TextureParser::read_gradient(std::optional<Affine> map) {
    auto gradient = make_counted<GradientPattern>();
    const Token at = peek();
    gradient->axis = vector();
    if (!failed() && gradient->axis == Vec3{0, 0, 0}) error(at, "expected a gradient other than 0");
    gradient->axis = normalize(gradient->axis);  // its length does not count in POV-Ray
    bool is_known = true;
    while (!failed() && !peek().is('}')) {
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
bool TextureParser::read_color_map(CountedVector<ColorMapEntry>& map) {
    if (!expect('{')) return false;
    while (!failed() && !accept('}')) {
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
    return !failed() && !map.empty();
}

}  // namespace glint::povray
