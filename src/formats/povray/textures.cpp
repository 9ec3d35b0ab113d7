// SPDX-License-Identifier: Apache-2.0
// Pigments, finishes, textures, materials.
#include <fmt/format.h>

#include "base/text.h"
#include "formats/povray/reader.h"
#include "formats/povray_keywords.h"
#include "math/elementary.h"

namespace glint::povray {

Missing Reader::missing(const Token& at, std::string_view name) {
    return {name, povray_meaning(name), call_place(at)};
}

// { [identifier] items }
void Reader::read_pigment(Pigment& pigment) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    std::optional<Affine> map;  // of a pattern: all patterns are missing
    while (!failed_ && !accept('}')) {
        const Token item = peek();
        if (begins_color(item)) {
            pigment = {color(false), {}, {}};
            continue;
        }
        if (item.kind == TokenKind::word && !Names::is_reserved(item.name)) {
            if (const Value* value = find_value(item.name)) {
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

// The factors of `albedo` are measured: with them a white surface sends back that share of the light.
double Finish::brightest_diffuse() const { return diffuse_albedo ? diffuse * (brilliance + 1) / 2 : diffuse; }

double Finish::brightest_phong() const { return phong_albedo ? phong * (phong_size + 1) / 2 : phong; }

double Finish::brightest_specular() const {
    if (!specular_albedo || !(roughness > 0)) return specular;
    const double exponent = 1 / roughness;
    return specular * (exponent + 2) / (4 * (2 - pow(2, -exponent / 2)));
}

void Reader::read_finish(Finish& finish) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    while (!failed_ && !accept('}')) {
        const Token item = take();
        switch (item.word()) {
            case Word::k_ambient:
                finish.ambient = rgb_of(color(true));
                break;
            case Word::k_emission:
                finish.emission = rgb_of(color(true));
                break;
            case Word::k_diffuse:
                if (!begins_number(peek())) finish.diffuse_albedo = take().kind == TokenKind::word;
                finish.diffuse = number();
                finish.diffuse_back = accept(',') ? number() : 0;
                break;
            case Word::k_brilliance:
                finish.brilliance = number();
                break;
            case Word::k_phong:
                if (!begins_number(peek())) finish.phong_albedo = take().kind == TokenKind::word;
                finish.phong = number();
                break;
            case Word::k_phong_size:
                finish.phong_size = number();
                break;
            case Word::k_specular:
                if (!begins_number(peek())) finish.specular_albedo = take().kind == TokenKind::word;
                finish.specular = number();
                break;
            case Word::k_roughness:
                finish.roughness = number();
                break;
            case Word::k_metallic:
                finish.metallic = number_or(1);
                break;
            case Word::k_crand:
                finish.crand = number();
                break;
            case Word::k_conserve_energy:
                finish.conserve_energy = flag();
                break;
            case Word::k_reflection:
                read_reflection(finish);
                break;
            case Word::k_reflection_exponent:
                finish.reflection_exponent = number();
                break;
            case Word::k_use_alpha:
            case Word::k_fresnel:
                flag();
                break;
            case Word::k_irid:
            case Word::k_subsurface:
                finish.missing.add(missing(item, to_string(item.word())));
                skip_block();
                break;
            case Word::k_ior:
                finish.interior = make_counted<const Opaque>(Opaque{Word::k_interior, item, number(), {}});
                break;
            default: {
                if (item.kind == TokenKind::word && text_of(item) == "refraction") {
                    finish.has_no_refraction = number() == 0;
                    break;
                }
                const auto held = named<Finish>(item);
                if (held == nullptr) {
                    return error(item, fmt::format("expected an item of a finish or `}}`, found {}{}",
                                                   describe(item), what_is(item)));
                }
                finish = *held;
            }
        }
        accept(',');
    }
}

// A color, or { [min,] max items }, after `reflection`.
void Reader::read_reflection(Finish& finish) {
    if (!peek().is('{')) {
        finish.reflection_min = finish.reflection_max = rgb_of(color(true));
        return;
    }
    take();
    bool has_min = false;
    while (!failed_ && !accept('}')) {
        switch (peek().word()) {
            case Word::k_fresnel:
                take();
                finish.reflection_fresnel = flag();
                break;
            case Word::k_falloff:
                take();
                finish.reflection_falloff = number();
                break;
            case Word::k_exponent:
                take();
                finish.reflection_exponent = number();
                break;
            case Word::k_metallic:
                take();
                finish.reflection_metallic = number_or(1);
                break;
            default:
                finish.reflection_max = rgb_of(color(true));
                if (!has_min) finish.reflection_min = finish.reflection_max;
                has_min = true;
        }
        accept(',');
    }
}

Texture Reader::read_texture() {
    Texture texture = default_texture_;
    read_texture_items(texture);
    return texture;
}

// { [identifier] items }
void Reader::read_texture_items(Texture& texture) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    std::optional<Affine> map;
    while (!failed_ && !accept('}')) {
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
            const bool is_name =
                item.kind == TokenKind::word && !Names::is_reserved(item.name) && find_value(item.name);
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
std::shared_ptr<const Texture> Reader::layered(const std::shared_ptr<const Texture>& below, Texture top) {
    top.is_layered = below != nullptr;
    return make_counted<const Texture>(std::move(top));
}

// The object's texture, to be changed: a copy of the default one if it has none.
Texture& Reader::own_texture(Object& object) {
    auto own = make_counted<Texture>(object.texture ? *object.texture : default_texture_);
    Texture& texture = *own;
    object.texture = std::move(own);
    return texture;
}

}  // namespace glint::povray
