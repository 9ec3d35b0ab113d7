// SPDX-License-Identifier: Apache-2.0
// The colors of patterns: color_map, and pigments and textures that differ in color only.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/texture_parser.h"

namespace glint::povray {
namespace {

// The colors of patterns without a map, as measured in POV-Ray's pictures. Those of others go from black to
// white.
struct DefaultColor {
    std::string_view word;
    float at, r, g, b;
};
constexpr DefaultColor k_default_colors[] = {
    {"wood", 0.6F, 0.666F, 0.312F, 0.2F},
    {"wood", 0.6F, 0.4F, 0.1333F, 0.066F},
    {"marble", 0, 0.9F, 0.8F, 0.8F},
    {"marble", 0.9F, 0.9F, 0.08F, 0.08F},
    {"marble", 0.9F, 0, 0, 0},
    {"radial", 0, 0, 1, 1},
    {"radial", 0.333F, 1, 1, 0},
    {"radial", 0.666F, 1, 0, 1},
    {"radial", 1, 0, 1, 1},
    {"bozo", 0.4F, 1, 1, 1},
    {"bozo", 0.4F, 0, 1, 0},
    {"bozo", 0.6F, 0, 1, 0},
    {"bozo", 0.6F, 0, 0, 1},
    {"bozo", 0.8F, 0, 0, 1},
    {"bozo", 0.8F, 1, 0, 0},
    {"agate", 0, 1, 1, 1},
    {"agate", 0.5F, 0.95F, 0.75F, 0.5F},
    {"agate", 0.5F, 0.9F, 0.7F, 0.5F},
    {"agate", 0.6F, 0.9F, 0.7F, 0.4F},
    {"agate", 0.6F, 1, 0.7F, 0.4F},
    {"agate", 1, 0.6F, 0.3F, 0},
    {"mandel", 0.001F, 0, 0, 0},
    {"mandel", 0.001F, 0, 1, 1},
    {"mandel", 0.012F, 1, 1, 0},
    {"mandel", 0.015F, 1, 0, 1},
    {"mandel", 0.1F, 0, 1, 1},
};

// Lets all be seen that is below it.
constexpr std::array<double, 5> k_clear{0, 0, 0, 0, 1};

constexpr std::size_t k_max_map = 256;  // entries of a color_map; POV-Ray's limit

bool is_in_order(const CountedVector<ColorMapEntry>& map) {
    const auto is_less = [](const ColorMapEntry& a, const ColorMapEntry& b) { return a.at < b.at; };
    return std::is_sorted(map.begin(), map.end(), is_less);
}

// The colors of a map, in order, from 0 to 1: those at 0 and 1 in place of colors beyond.
CountedVector<ColorMapEntry> from_0_to_1(const CountedVector<ColorMapEntry>& map) {
    CountedVector<ColorMapEntry> out;
    out.reserve(map.size() + 1);
    const auto add_between = [&](const ColorMapEntry& a, const ColorMapEntry& b, double at) {
        ColorMapEntry entry{at, a.color};
        for (std::size_t c = 0; c < entry.color.size(); ++c)
            entry.color[c] += (b.color[c] - a.color[c]) * ((at - a.at) / (b.at - a.at));
        out.push_back(entry);
    };
    for (std::size_t i = 0; i < map.size(); ++i) {
        const ColorMapEntry& entry = map[i];
        const bool crosses_0 = i > 0 && map[i - 1].at < 0 && entry.at > 0;
        if (crosses_0) add_between(map[i - 1], entry, 0);
        if (entry.at > 1) {
            if (i > 0 && map[i - 1].at < 1) add_between(map[i - 1], entry, 1);
            if (out.empty()) out.push_back({1, entry.color});
            return out;
        }
        if (entry.at >= 0) out.push_back(entry);
    }
    if (out.empty() && !map.empty()) out.push_back({0, map.back().color});
    return out;
}

}  // namespace

CountedVector<ColorMapEntry> TextureParser::default_map(std::string_view word) {
    CountedVector<ColorMapEntry> map;
    for (const DefaultColor& c : k_default_colors)
        if (c.word == word) map.push_back({c.at, {c.r, c.g, c.b}});
    if (map.empty()) map = {{0, {}}, {1, {1, 1, 1}}};
    return map;
}

// Makes a map one of places from 0 to 1. False if its places are not in order.
bool TextureParser::use_from_0_to_1(CountedVector<ColorMapEntry>& map) {
    if (!is_in_order(map)) return false;
    map = from_0_to_1(map);
    return true;
}

// A color, a pigment or a texture, or nothing.
std::optional<std::array<double, 5>> TextureParser::read_block_color(PatternParts& parts) {
    const Token next = peek();
    if (accept(Word::k_texture)) {
        parts.are_textures = true;
        return color_of(read_texture(), parts);
    }
    if (accept(Word::k_pigment)) {
        Pigment pigment = default_texture().pigment;
        read_pigment(pigment);
        return color_of(pigment, parts);
    }
    const bool is_name =
        next.kind == TokenKind::word && !Names::is_reserved(next.name) && find_value(next) != nullptr;
    if (!(begins_color(next) || begins_number(next) || is_name)) return std::nullopt;
    return color(true);
}

// The color of a pigment of one color. The first one with a pattern is seen through a clear color.
std::array<double, 5> TextureParser::color_of(const Pigment& pigment, PatternParts& parts) {
    if (!pigment.missing && !pigment.image && pigment.image_number == 0) {
        parts.are_opaque = parts.are_opaque && lets_nothing_through(pigment);
        return pigment.color;
    }
    const bool is_drawn = (pigment.image || pigment.under) && lets_nothing_through(pigment);
    if (is_drawn && !parts.under) parts.under = make_counted<const Pigment>(pigment);
    parts.are_plain = parts.are_plain && is_drawn && !pigment.is_uv && pigment == *parts.under;
    return k_clear;
}

// A clear entry has the color of the one beside it, so that only the opacity changes between them.
void TextureParser::use_colors_beside(CountedVector<ColorMapEntry>& map) {
    CountedVector<ColorMapEntry> out;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (map[i].color != k_clear) {
            out.push_back(map[i]);
            continue;
        }
        for (const std::size_t other : {i - 1, i + 1}) {
            if (other >= map.size()) continue;
            ColorMapEntry entry{map[i].at, map[other].color};
            entry.color[4] = 1;
            out.push_back(entry);
        }
        if (map.size() == 1) out.push_back(map[i]);
    }
    map = std::move(out);
}

// Draws the one with a pattern below the colors.
void TextureParser::put_under(Pigment& pigment, const PatternParts& parts) {
    if (!parts.under || !pigment.image) return;
    pigment.under = parts.under;
    pigment.pattern = nullptr;
    pigment.gradient = nullptr;
    if (!pigment.missing) pigment.missing = parts.under->missing;
}

std::array<double, 5> TextureParser::color_of(const Texture& texture, PatternParts& parts) {
    for (const Missing& missing : texture.missing) parts.missing.add(missing);
    parts.are_plain = parts.are_plain && !texture.below;
    if (parts.first) {
        Texture recolored = texture;
        recolored.pigment = parts.first->pigment;
        recolored.layers_number = parts.first->layers_number;
        const bool is_same = numbers_of(recolored) == numbers_of(*parts.first) &&
                             texture.finish.missing.empty() == parts.first->finish.missing.empty();
        parts.have_one_finish = parts.have_one_finish && is_same;
    } else {
        parts.first = texture;
    }
    return color_of(texture.pigment, parts);
}

// { [number pigment] ... }, or of textures.
bool TextureParser::read_part_map(CountedVector<ColorMapEntry>& map, PatternParts& parts) {
    if (!expect('{')) return false;
    while (!failed() && !accept('}')) {
        const Token at = peek();
        if (!at.is('[')) {  // a named map
            skip_rest();
            parts.are_plain = false;
            expect('}');
            break;
        }
        take();
        ColorMapEntry entry{number(), {}};
        accept(',');
        if (parts.are_textures) {
            Texture texture = default_texture();
            read_texture_items(texture, ']');
            entry.color = color_of(texture, parts);
        } else {
            Pigment pigment = default_texture().pigment;
            read_pigment_items(pigment, ']');
            entry.color = color_of(pigment, parts);
        }
        accept(',');
        map.push_back(entry);
        if (map.size() > k_max_map) error(at, fmt::format("expected at most {} entries", k_max_map));
    }
    if (parts.under) use_colors_beside(map);
    return !failed() && !map.empty();
}

const Opaque* TextureParser::named_block(const Token& name, Word word) {
    const Value* const value = name.kind == TokenKind::word ? find_value(name) : nullptr;
    const auto* const held = value ? std::get_if<std::shared_ptr<const Opaque>>(value) : nullptr;
    return held && (*held)->word == word ? held->get() : nullptr;
}

// { [identifier] [number color] ... }; also [number number color color]. False for a map without colors.
bool TextureParser::read_color_map(CountedVector<ColorMapEntry>& map) {
    if (!expect('{')) return false;
    while (!failed() && !accept('}')) {
        const Token at = peek();
        const Opaque* named = named_block(at, Word::k_color_map);
        if (!named) named = named_block(at, Word::k_colour_map);
        if (named) {
            take();
            map = named->map;
            continue;
        }
        if (!at.is('[')) {
            skip_rest();
            expect('}');
            break;
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
