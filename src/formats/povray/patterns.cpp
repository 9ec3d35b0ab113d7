// SPDX-License-Identifier: Apache-2.0
// Patterns of colors: checker, gradient and others, and their maps of colors. What each means was measured in
// POV-Ray's pictures (tests/peers/patterns.py).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/povray/texture_parser.h"
#include "math/transform.h"
#include "scene/texture_fields.h"

namespace glint::povray {
namespace {

// The axes turned: x, y, z of the mapping are x, y, z of the pattern's row.
constexpr Affine k_same{};
constexpr Affine k_y_is_z{{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}}};
constexpr Affine k_x_is_z{{{0, 0, -1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}};
constexpr Affine k_x_is_y{{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}};

}  // namespace

struct PatternRow {
    // How the pattern's number comes from the mapping's u. periodic: u - floor(u); inward: 1 - u, 0 from u =
    // 1 on; plain: u; unit: u, from 0 to 1.
    enum class Range : std::uint8_t { periodic, inward, plain, unit };

    std::string_view word;
    TextureMapping mapping;
    Range range = Range::periodic;
    bool is_triangle = false;  // without a wave of its own
    double offset = 0;         // added to u
    Affine pattern_from_mapping = k_same;
    double turbulence = 0;  // of the pattern itself
};

namespace {

using Range = PatternRow::Range;
constexpr PatternRow k_patterns[] = {
    {"checker", TextureMapping::checker},
    {"gradient", TextureMapping::planar},
    {"onion", TextureMapping::onion},
    {"wood", TextureMapping::rings, Range::periodic, true, 0, k_y_is_z},
    {"marble", TextureMapping::planar, Range::periodic, true},
    {"radial", TextureMapping::cylindrical, Range::periodic, false, 0.25},
    {"spherical", TextureMapping::onion, Range::inward},
    {"cylindrical", TextureMapping::rings, Range::inward},
    {"planar", TextureMapping::slabs, Range::inward, false, 0, k_x_is_y},
    {"boxed", TextureMapping::boxes, Range::inward},
    {"leopard", TextureMapping::leopard, Range::plain},
    {"brick", TextureMapping::bricks},
    {"hexagon", TextureMapping::hexagons},
    {"bozo", TextureMapping::noise, Range::plain},
    {"spotted", TextureMapping::noise, Range::plain},
    {"bumps", TextureMapping::noise, Range::plain},
    {"granite", TextureMapping::granite, Range::plain},
    {"wrinkles", TextureMapping::wrinkles, Range::plain},
    {"agate", TextureMapping::planar, Range::periodic, true, 0, k_x_is_z, 1.5},
    {"spiral1", TextureMapping::spiral, Range::periodic, true, 0, k_y_is_z},
    {"mandel", TextureMapping::mandelbrot, Range::unit},
};

// A rotation that takes the x axis to a direction of length 1.
Affine x_to(Vec3 d) {
    const Vec3 least = number::abs(d.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 side = normalize(cross(d, least)), up = cross(side, d);
    return {{{d.x, side.x, up.x, 0}, {d.y, side.y, up.y, 0}, {d.z, side.z, up.z, 0}}};
}

// Patterns of a few colors with sharp borders, and these colors.
std::vector<TextureColor> block_colors(TextureMapping mapping) {
    switch (mapping) {
        case TextureMapping::checker:
            return {{0, {0, 0, 1}}, {0.5, {0, 1, 0}}};
        case TextureMapping::bricks:
            return {{0, {0.5, 0.5, 0.5}}, {0.5, {0.6, 0.15, 0.15}}};
        case TextureMapping::hexagons:
            return {{0, {0, 0, 1}}, {0.25, {0, 1, 0}}, {0.5, {1, 0, 0}}};
        default:
            return {};
    }
}

// Sets the turbulence, that of the pattern itself included, along the mapping's axes. Whether there is noise.
bool set_noise(glint::Texture& texture, const PatternItems& items, double own) {
    const Vec3 t = items.turbulence + Vec3{own, own, own};
    const Affine to_mapping = inverse(texture.world_from_texture).value_or(Affine{});
    const auto& m = to_mapping.m;
    const auto along = [&](int axis) {
        return length(Vec3{m[axis][0] * t.x, m[axis][1] * t.y, m[axis][2] * t.z});
    };
    texture.turbulence = Vec3{along(0), along(1), along(2)};
    texture.octaves = std::clamp(std::floor(items.octaves), 1.0, 10.0);
    texture.gain = std::clamp(items.omega, 0.0, 1.0);
    texture.lacunarity = items.lambda;
    return texture.mapping == TextureMapping::noise || texture.mapping == TextureMapping::granite ||
           texture.mapping == TextureMapping::wrinkles || !(t == Vec3{});
}

// POV-Ray's places are floats, and at the place of two colors it has the first one, at 1 the last one. Only
// patterns of few numbers are often at such a place.
double after(double at) { return at < 1 ? static_cast<float>(at) * (1 + 0x1p-52) : at; }

// Uses the number after `spiral1` and `mandel`. Whether the engine has such a pattern.
bool use_number(glint::Texture& texture, double number) {
    if (texture.mapping == TextureMapping::spiral) {
        auto& m = texture.uv_map.m[0];
        m[1] = m[0] * number;  // v is 0.75 along the pattern's x axis, where POV-Ray has 0.25
        m[2] += m[1] / 2;
        return number::abs(number) <= 1e6;
    }
    if (texture.mapping != TextureMapping::mandelbrot) return true;
    texture.iterations = number;
    return k_iterations.contains(number);
}

// How `frequency`, `phase` and the wave change u: factor u + offset, wrapped. Nothing if the engine has no
// such map.
struct Change {
    double factor = 1, offset = 0;
    TextureWrap wrap = TextureWrap::repeat;
};
std::optional<Change> change_of(const PatternRow& row, const PatternItems& items) {
    const bool is_triangle = items.is_triangle.value_or(row.is_triangle);
    Change change{items.frequency, items.frequency * row.offset + items.phase, TextureWrap::repeat};
    if (row.range == Range::inward) {
        change = {-1, 1, TextureWrap::clamp};
        if (items.frequency != 1 || items.phase != 0 || is_triangle) return std::nullopt;
    } else if (row.range == Range::unit) {
        if (items.frequency != 1 || items.phase != 0) return std::nullopt;  // 1 would be 0
        change.wrap = TextureWrap::clamp;
    } else if (row.range == Range::periodic && std::floor(items.frequency) != items.frequency) {
        return std::nullopt;  // POV-Ray multiplies the fraction
    }
    if (is_triangle) change = {2 * change.factor, 2 * change.offset, TextureWrap::mirror};
    return change;
}

}  // namespace

// The pattern of this word, after it, or nothing if it is not drawn: the pigment is `missing` then. Reads the
// rest of the block. map: of the transforms in the block.
void TextureParser::read_pattern(Pigment& pigment, const Token& item, std::optional<Affine>& map,
                                 PatternParts& parts) {
    const PatternRow* const row = find_pattern(text_of(item));
    const CountedVector<ColorMapEntry> kept = map_without_own(pigment, row);
    pigment.missing = missing(item, text_of(item));
    pigment.missing->meaning = "a pattern";
    // What a named pigment before it had, or the default one. POV-Ray keeps what is not its pattern.
    const bool loses = pigment.map || (pigment.pattern && pigment.pattern->items.changes_u());
    pigment.gradient = nullptr;
    pigment.image = nullptr;
    pigment.image_number = 0;
    pigment.pattern = nullptr;
    pigment.under = nullptr;
    pigment.map.reset();
    if (text_of(item) == "average") return read_average(pigment, map);
    if (row == nullptr) return skip_rest();
    PatternSource source{row, item, {}};
    glint::Texture& texture = source.texture;
    texture.mapping = row->mapping;
    texture.world_from_texture = row->pattern_from_mapping;
    texture.color_map = block_colors(row->mapping);
    source.has_filter = !texture.color_map.empty() && read_block_colors(texture, parts);
    Vec3& axis = source.axis;
    if (row->word == "gradient") {
        const Token at = peek();
        axis = vector();
        if (!failed() && axis == Vec3{0, 0, 0}) error(at, "expected a gradient other than 0");
        axis = normalize(axis);  // its length does not count in POV-Ray
        texture.world_from_texture = x_to(axis);
    }
    if (row->mapping == TextureMapping::spiral || row->mapping == TextureMapping::mandelbrot)
        source.number = std::trunc(number());
    PatternItems& items = source.items;
    read_pattern_items(items, map, parts);
    if (failed()) return;
    if (items.map.empty() && texture.color_map.empty()) items.map = kept;
    const bool is_plain = items.frequency == 1 && items.phase == 0 && !items.is_triangle.value_or(false);
    if (row->word == "gradient" && items.is_known && parts.are_plain && !parts.under && is_plain &&
        items.turbulence == Vec3{}) {
        auto gradient = make_counted<GradientPattern>();
        *gradient = {axis, items.map, map};
        pigment.gradient = std::move(gradient);
    }
    // Turbulence would move the pattern below, too.
    const bool is_drawn =
        parts.are_plain && (!parts.under || (parts.are_opaque && items.turbulence == Vec3{}));
    draw_pattern(pigment, std::move(source), is_drawn);
    put_under(pigment, parts);
    if (loses && !pigment.missing)
        pigment.missing = {text_of(item), "in place of another pattern, whose transforms POV-Ray keeps",
                           call_place(item)};
}

// The map of a pattern that has none of its own: what the pigment had before it, or the pattern's default
// one. Nothing if it is not known.
CountedVector<ColorMapEntry> TextureParser::map_without_own(const Pigment& before, const PatternRow* row) {
    if (row == nullptr || before.under || (before.missing && !before.image)) return {};
    if (before.pattern)
        return before.pattern->texture.color_map.empty() ? before.pattern->items.map
                                                         : CountedVector<ColorMapEntry>();
    return before.image ? CountedVector<ColorMapEntry>() : default_map(row->word);
}

const PatternRow* TextureParser::find_pattern(std::string_view word) {
    const auto row = std::find_if(std::begin(k_patterns), std::end(k_patterns),
                                  [&](const PatternRow& p) { return p.word == word; });
    return row == std::end(k_patterns) ? nullptr : row;
}

// Words after the name of a pigment with a pattern: what they say replaces what it has.
void TextureParser::change_pattern(Pigment& pigment, std::optional<Affine>& map) {
    PatternSource source = *pigment.pattern;
    CountedVector<ColorMapEntry> colors;
    colors.swap(source.items.map);
    PatternParts parts;
    read_pattern_items(source.items, map, parts);
    if (failed()) return;
    if (source.items.map.empty()) source.items.map = std::move(colors);
    pigment.missing = missing(source.at, source.row->word);
    pigment.missing->meaning = "a pattern";
    pigment.gradient = nullptr;
    pigment.image = nullptr;
    pigment.image_number = 0;
    draw_pattern(pigment, std::move(source), parts.are_plain && !parts.under);
}

// The pigment of what has been read, which is `missing` if the engine has no such pattern.
void TextureParser::draw_pattern(Pigment& pigment, PatternSource source, bool are_plain) {
    const PatternRow* const row = source.row;
    glint::Texture texture = source.texture;
    PatternItems items = source.items;
    const Token item = source.at;
    const double count = source.number;
    bool has_filter = source.has_filter;
    const bool is_block = !texture.color_map.empty();
    pigment.pattern = make_counted<const PatternSource>(std::move(source));
    items.is_known = items.is_known && are_plain && items.lambda > 0 && items.lambda <= 1e12;
    if (row->mapping == TextureMapping::bricks) {
        const Vec3 size = items.brick_size;
        if (!(size.x > 0 && size.y > 0 && size.z > 0)) return;
        texture.world_from_texture = scaling(size);
        const auto part = [&](double side) { return std::clamp(items.mortar / side, 0.0, 1.0); };
        texture.mortar = {part(size.x), part(size.y), part(size.z)};
    }
    const std::optional<Change> change = is_block ? Change{} : change_of(*row, items);
    if (!items.is_known || !change || (!is_block && items.map.empty())) return;
    for (const ColorMapEntry& entry : items.map) {
        has_filter = has_filter || entry.color[3] != 0;
        texture.color_map.push_back({row->range == Range::unit ? after(entry.at) : entry.at,
                                     rgb_of(entry.color), opacity_of(entry.color)});
    }
    texture.uv_map.m[0][0] = change->factor;
    texture.uv_map.m[0][2] = change->offset;
    if (!use_number(texture, count)) return;
    texture.wrap_u = change->wrap;
    pigment.missing.reset();
    if (set_noise(texture, items, row->turbulence))
        pigment.missing = {"noise", "of patterns: glint has its own, with another grain", call_place(item)};
    else if (has_filter)
        pigment.missing = {"filter", "of a map of colors: it is drawn as transmit", call_place(item)};
    pigment.color = {1, 1, 1, 0, 0};
    pigment.image = make_counted<const glint::Texture>(std::move(texture));
    pigment.image_number = ++images_;
}

// The colors of a pattern that has some by itself, in place of these; whether one has a filter. After a
// pigment or a texture, those that are missing are the default one (measured).
bool TextureParser::read_block_colors(glint::Texture& texture, PatternParts& parts) {
    texture.filter = TextureFilter::nearest;
    bool has_filter = false;
    const bool are_pigments = peek().word() == Word::k_pigment;
    for (TextureColor& entry : texture.color_map) {
        std::optional<std::array<double, 5>> c = read_block_color(parts);
        const bool is_first = &entry == texture.color_map.data();
        if (!c && !is_first && parts.are_textures) c = color_of(default_texture(), parts);
        if (!c && are_pigments) c = color_of(default_texture().pigment, parts);
        if (failed() || !c) break;
        entry.color = rgb_of(*c);
        entry.alpha = opacity_of(*c);
        has_filter = has_filter || (*c)[3] != 0;
        accept(',');
    }
    return has_filter;
}

void TextureParser::read_pattern_items(PatternItems& items, std::optional<Affine>& map, PatternParts& parts) {
    while (!failed() && !peek().is('}') && !peek().is(']')) {
        if (read_transform_item(map)) continue;
        if (accept(Word::k_color_map) || accept(Word::k_colour_map)) {
            items.is_known = read_color_map(items.map) && use_from_0_to_1(items.map) && items.is_known;
            continue;
        }
        if (accept(Word::k_quick_color) || accept(Word::k_quick_colour)) {
            color(true);
            continue;
        }
        const Token item = peek();
        const std::string_view word = item.kind == TokenKind::word ? text_of(item) : std::string_view();
        if (word == "pigment_map" || word == "texture_map") {
            take();
            parts.are_textures = word == "texture_map";
            items.is_known = read_part_map(items.map, parts) && use_from_0_to_1(items.map) && items.is_known;
        } else if (word == "brick_size") {
            take();
            items.brick_size = vector();
        } else if (word == "mortar") {
            take();
            items.mortar = number();
        } else if (word == "frequency" || word == "phase") {
            take();
            (word == "phase" ? items.phase : items.frequency) = number();
        } else if (word == "turbulence") {
            take();
            items.turbulence = vector();
        } else if (word == "octaves" || word == "omega" || word == "lambda") {
            take();
            (word == "octaves" ? items.octaves : word == "omega" ? items.omega : items.lambda) = number();
        } else if (word == "ramp_wave" || word == "triangle_wave") {
            take();
            items.is_triangle = word == "triangle_wave";
        } else {
            items.is_known = false;
            skip_rest();
        }
    }
}

}  // namespace glint::povray
