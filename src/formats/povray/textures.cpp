// SPDX-License-Identifier: Apache-2.0
// Pigments and textures.
#include <fmt/format.h>

#include "formats/povray/texture_parser.h"
#include "formats/povray_keywords.h"

namespace glint::povray {
namespace {

Pigment color_pigment(const std::array<double, 5>& color) {
    Pigment pigment;
    pigment.color = color;
    return pigment;
}

}  // namespace

Missing TextureParser::missing(const Token& at, std::string_view name) {
    return {name, povray_meaning(name), call_place(at)};
}

void TextureParser::read_pigment(Pigment& pigment) {
    if (expect('{')) read_pigment_items(pigment, '}');
}

// [identifier] items, and the symbol at the end
void TextureParser::read_pigment_items(Pigment& pigment, char end) {
    const Deeper deeper(*this);
    if (!deeper.ok) return;
    std::optional<Affine> map;  // of the pattern
    bool is_placed = false;     // by a named pigment's uv_mapping
    while (!failed() && !accept(end)) {
        const Token item = peek();
        if (begins_color(item)) {
            pigment = color_pigment(color(false));
            continue;
        }
        if (item.kind == TokenKind::word && !Names::is_reserved(item.name)) {
            if (const Value* value = find_value(item)) {
                const auto* array = std::get_if<std::shared_ptr<Array>>(value);
                const Value& kind =
                    array && !(*array)->elements.empty() ? (*array)->elements.front() : *value;
                if (std::holds_alternative<std::shared_ptr<const Pigment>>(kind)) {
                    if (const auto held = named<Pigment>(take())) pigment = *held;
                    is_placed = pigment.is_uv;
                    continue;
                }
                pigment = color_pigment(color(false));
                continue;
            }
        } else if (item.word() == Word::k_quick_color || item.word() == Word::k_quick_colour) {
            take();
            color(true);
            continue;
        } else if (begins_number(item)) {
            pigment = color_pigment(color(false));
            continue;
        } else if (read_transform_item(map)) {
            continue;
        } else if (accept(Word::k_uv_mapping)) {
            pigment.is_uv = true;
            continue;
        } else if (accept(Word::k_image_map)) {
            read_image_map(pigment, item);
            continue;
        }
        if (item.kind == TokenKind::word && pigment.pattern && !find_pattern(text_of(item))) {
            change_pattern(pigment, map);
            continue;
        }
        take();
        if (item.kind != TokenKind::word) {
            return error(item, fmt::format("expected a color or a pattern, found {}", describe(item)));
        }
        PatternParts parts;
        read_pattern(pigment, item, map, parts);
    }
    if (!is_placed) transform_image(pigment, map);
}

Texture TextureParser::read_texture() {
    Texture texture = default_texture_;
    if (expect('{')) read_texture_items(texture, '}');
    return texture;
}

// [identifier] items, and the symbol at the end
void TextureParser::read_texture_items(Texture& texture, char end) {
    const Deeper deeper(*this);
    if (!deeper.ok) return;
    bool is_placed = false;  // by a named texture's uv_mapping
    while (!failed() && !accept(end)) {
        const Token item = peek();
        if (std::optional<Affine> step; read_transform_item(step)) {
            if (!is_placed && !texture.pigment.is_uv) transform_image(texture.pigment, step);
            transform_below(texture, step);
            continue;
        }
        if (accept(Word::k_uv_mapping)) {
            texture.is_uv = true;
            continue;
        }
        if (accept(Word::k_no_bump_scale)) continue;
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
                const bool is_uv = texture.is_uv;
                texture = *held;
                is_placed = texture.is_uv;
                texture.is_uv = texture.is_uv || is_uv;
            } else if (const auto pigment = named<Pigment>(item)) {
                texture.pigment = *pigment;
            } else if (!is_name && item.kind == TokenKind::word) {
                read_texture_pattern(texture, item);
            } else {
                return error(item, fmt::format("expected `pigment`, `finish` or a texture, found {}{}",
                                               describe(item), what_is(item)));
            }
        }
    }
}

// A pattern of whole textures: those that differ in color only are a pattern of colors.
void TextureParser::read_texture_pattern(Texture& texture, const Token& item) {
    PatternParts parts;
    parts.are_textures = true;
    std::optional<Affine> map;
    Pigment pigment = texture.pigment;
    read_pattern(pigment, item, map, parts);
    transform_image(pigment, map);
    if (parts.first) texture = *parts.first;
    if (pigment.missing && !pigment.image && parts.first)
        pigment.color = parts.first->pigment.color;  // the color of the first one, with the warning
    texture.pigment = pigment;
    for (const Missing& missing : parts.missing) texture.missing.add(missing);
    if (!parts.have_one_finish)
        texture.missing.add({text_of(item), "of textures with several finishes: all have that of the first",
                             call_place(item)});
}

// The texture `top`, which may have layers itself, over `below`.
std::shared_ptr<const Texture> TextureParser::layered(const std::shared_ptr<const Texture>& below,
                                                      Texture top) {
    if (below && top.layers + below->layers > k_max_texture_layers) {
        top.missing.add({"layered textures", "more of them than 16: the lowest are left out", peek()});
    } else if (below) {
        top.layers += below->layers;
        top.layers_number = ++images_;
        top.below = top.below ? layered(below, *top.below) : below;
    }
    return make_counted<const Texture>(std::move(top));
}

// A texture over the object's, which the transforms up to here have moved.
void TextureParser::add_layer(Object& object, Texture top) {
    if (object.texture && object.texture_map && is_clear(top)) {
        Texture below = *object.texture;
        if (!below.has_own_place()) transform_image(below.pigment, object.texture_map);
        transform_below(below, object.texture_map);
        object.texture = make_counted<const Texture>(std::move(below));
    }
    object.texture = layered(object.texture, std::move(top));
    object.texture_map.reset();
}

// Moves the images of the layers below.
void TextureParser::transform_below(Texture& texture, const std::optional<Affine>& step) {
    if (!step || !texture.below) return;
    Texture below = *texture.below;
    if (!below.has_own_place()) transform_image(below.pigment, step);
    transform_below(below, step);
    texture.below = make_counted<const Texture>(std::move(below));
    texture.layers_number = ++images_;
}

// The object's texture, to be changed: a copy of the default one if it has none.
Texture& TextureParser::own_texture(Object& object) {
    auto own = make_counted<Texture>(object.texture ? *object.texture : default_texture_);
    Texture& texture = *own;
    object.texture = std::move(own);
    return texture;
}

}  // namespace glint::povray
