// SPDX-License-Identifier: Apache-2.0
// Blocks that are read over: normals, functions, maps. Interiors and materials.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/texture_parser.h"

namespace glint::povray {

void MissingList::add(const Missing& missing) {
    const auto is_same = [&](const Missing& m) {
        return m.name == missing.name && m.is_error == missing.is_error;
    };
    if (std::any_of(list_.begin(), list_.end(), is_same)) return;
    if (list_.size() < 16 || missing.is_error) list_.push_back(missing);
}

bool MissingList::has_error() const {
    return std::any_of(list_.begin(), list_.end(), [](const Missing& m) { return m.is_error; });
}

// The rest of a block or of an entry of a map, up to its `}` or `]`.
void TextureParser::skip_rest() {
    int open = 0;
    while (!failed()) {
        const Token& token = peek();
        if (token.kind == TokenKind::end) return expected("`}`");
        if (token.is('{') || token.is('[')) ++open;
        if ((token.is('}') || token.is(']')) && open-- == 0) return;
        take();
    }
}

void TextureParser::skip_rest_of_block() {
    skip_rest();
    if (!failed() && !peek().is('}')) expected("`}`");
}

void TextureParser::skip_block() {
    if (!expect('{')) return;
    skip_rest();
    expect('}');
}

bool TextureParser::is_opaque(Word word) {
    return word == Word::k_normal || word == Word::k_interior || word == Word::k_color_map ||
           word == Word::k_colour_map || word == Word::k_function || word == Word::k_rainbow ||
           word == Word::k_sky_sphere || word == Word::k_fog;
}

// A block that has a meaning only where it is used, after its word.
std::shared_ptr<const Opaque> TextureParser::read_opaque(Word word, const Token& at) {
    if (word == Word::k_interior) return make_counted<const Opaque>(read_interior(at));
    if (word == Word::k_function && peek().is('(')) {
        while (!failed() && !accept(')')) {
            if (peek().kind == TokenKind::end) expected("`)`");
            take();
        }
    }
    Opaque out{word, at};
    if (word == Word::k_color_map || word == Word::k_colour_map) {
        read_color_map(out.map);
    } else if (word == Word::k_sky_sphere) {
        out.sky = read_sky_items();
    } else {
        skip_block();
    }
    return make_counted<const Opaque>(std::move(out));
}

// { [identifier] items }, after `interior`; added to one before it
Opaque TextureParser::read_interior(const Token& at, const Opaque* before) {
    Opaque out = before ? *before : Opaque{Word::k_interior, at};
    if (!expect('{')) return out;
    while (!failed() && !accept('}')) {
        const Token item = take();
        const std::string_view name = item.kind == TokenKind::word ? text_of(item) : std::string_view();
        const Value* value = find_value(item);
        if (const auto* held = value ? std::get_if<std::shared_ptr<const Opaque>>(value) : nullptr) {
            out.ior = (*held)->ior;
            out.fade = (*held)->fade;
            out.caustics = (*held)->caustics;
            out.missing = (*held)->missing;
        } else if (item.word() == Word::k_ior) {
            out.ior = number();
        } else if (item.word() == Word::k_fade_distance) {
            out.fade.distance = number();
        } else if (item.word() == Word::k_fade_power) {
            out.fade.power = number();
        } else if (item.word() == Word::k_fade_color || item.word() == Word::k_fade_colour) {
            const Color given = rgb_of(color(true));
            out.fade.color = {std::max(given.r, 0.0), std::max(given.g, 0.0), std::max(given.b, 0.0)};
            if (!(out.fade.color == given)) out.missing.add({"fade_color", "below 0", call_place(item)});
        } else if (name == "caustics") {
            out.caustics = number();
        } else if (name == "dispersion") {
            if (number() != 1) out.missing.add(missing(item, name));
        } else if (name == "media") {
            skip_block();
            out.missing.add({"media", "smoke or haze inside an object", call_place(item)});
        } else if (item.kind == TokenKind::end) {
            expected("`}`");
        } else if (item.is('{')) {
            skip_rest();
            expect('}');
        }
    }
    return out;
}

// { [identifier] texture interior transforms }; the interior is added to one before it, an identifier
// replaces that. (Measured)
MaterialValue TextureParser::read_material(std::shared_ptr<const Opaque> before) {
    MaterialValue material;
    material.interior = std::move(before);
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return material;
    while (!failed() && !accept('}')) {
        if (std::optional<Affine> step; read_transform_item(step)) {
            if (!material.texture || !(material.texture->pigment.image || material.texture->below)) continue;
            auto moved = make_counted<Texture>(*material.texture);
            if (!moved->has_own_place()) transform_image(moved->pigment, step);
            transform_below(*moved, step);
            material.texture = std::move(moved);
            continue;
        }
        const Token item = take();
        if (item.word() == Word::k_texture) {
            material.texture = layered(material.texture, read_texture());
        } else if (item.word() == Word::k_interior) {
            material.interior = make_counted<const Opaque>(read_interior(item, material.interior.get()));
        } else if (item.word() == Word::k_interior_texture) {
            skip_block();
            material.missing.add(missing(item, "interior_texture"));
        } else if (const auto held = named<MaterialValue>(item)) {
            material = *held;
        } else {
            error(item, fmt::format("expected `texture`, `interior` or `}}`, found {}{}", describe(item),
                                    what_is(item)));
        }
    }
    return material;
}

}  // namespace glint::povray
