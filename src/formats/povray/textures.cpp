// SPDX-License-Identifier: Apache-2.0
// Pigments and textures.
#include <fmt/format.h>

#include "formats/povray/texture_parser.h"
#include "formats/povray_keywords.h"

namespace glint::povray {

Missing TextureParser::missing(const Token& at, std::string_view name) {
    return {name, povray_meaning(name), call_place(at)};
}

// { [identifier] items }
void TextureParser::read_pigment(Pigment& pigment) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    std::optional<Affine> map;  // of a pattern: all patterns are missing
    while (!failed() && !accept('}')) {
        const Token item = peek();
        if (begins_color(item)) {
            pigment = {color(false), {}, {}};
            continue;
        }
        if (item.kind == TokenKind::word && !Names::is_reserved(item.name)) {
            if (const Value* value = find_value(item)) {
                const auto* array = std::get_if<std::shared_ptr<Array>>(value);
                const Value& kind =
                    array && !(*array)->elements.empty() ? (*array)->elements.front() : *value;
                if (std::holds_alternative<std::shared_ptr<const Pigment>>(kind)) {
                    if (const auto held = named<Pigment>(take())) pigment = *held;
                    continue;
                }
                pigment = {color(false), {}, {}};
                continue;
            }
        } else if (item.word() == Word::k_quick_color || item.word() == Word::k_quick_colour) {
            take();
            color(true);
            continue;
        } else if (begins_number(item)) {
            pigment = {color(false), {}, {}};
            continue;
        } else if (read_transform_item(map) || accept(Word::k_uv_mapping)) {
            continue;
        }
        take();
        if (item.kind != TokenKind::word) {
            return error(item, fmt::format("expected a color or a pattern, found {}", describe(item)));
        }
        pigment.missing = missing(item, text_of(item));
        pigment.missing->meaning = "a pattern";
        if (item.word() == Word::k_gradient) {
            pigment.gradient = read_gradient(map);
        } else {
            skip_rest();
        }
    }
}

Texture TextureParser::read_texture() {
    Texture texture = default_texture_;
    read_texture_items(texture);
    return texture;
}

// { [identifier] items }
void TextureParser::read_texture_items(Texture& texture) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    std::optional<Affine> map;
    while (!failed() && !accept('}')) {
        const Token item = peek();
        if (read_transform_item(map) || accept(Word::k_uv_mapping) || accept(Word::k_no_bump_scale)) continue;
        take();
        if (item.word() == Word::k_pigment) {
            read_pigment(texture.pigment);
        } else if (item.word() == Word::k_finish) {
            read_finish(texture.finish);
        } else if (item.word() == Word::k_normal) {
            skip_block();
            texture.missing.add(missing(item, "normal"));
        } else {
            const bool is_name = find_value(item) != nullptr;
            if (const auto held = named<Texture>(item)) {
                texture = *held;
            } else if (const auto pigment = named<Pigment>(item)) {
                texture.pigment = *pigment;
            } else if (!is_name && item.kind == TokenKind::word) {
                texture.missing.add(missing(item, text_of(item)));  // a map of textures, tiles, ...
                skip_rest();
            } else {
                return error(item, fmt::format("expected `pigment`, `finish` or a texture, found {}{}",
                                               describe(item), what_is(item)));
            }
        }
    }
}

// The texture `top` over `below`.
std::shared_ptr<const Texture> TextureParser::layered(const std::shared_ptr<const Texture>& below,
                                                      Texture top) {
    top.is_layered = below != nullptr;
    return make_counted<const Texture>(std::move(top));
}

// The object's texture, to be changed: a copy of the default one if it has none.
Texture& TextureParser::own_texture(Object& object) {
    auto own = make_counted<Texture>(object.texture ? *object.texture : default_texture_);
    Texture& texture = *own;
    object.texture = std::move(own);
    return texture;
}

}  // namespace glint::povray
