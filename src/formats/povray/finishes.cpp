// SPDX-License-Identifier: Apache-2.0
// Finishes.
#include <fmt/format.h>

#include "formats/povray/texture_parser.h"
#include "math/elementary.h"

namespace glint::povray {

namespace {

// `albedo`: the number is of all the light that the surface sends back, not of its brightest place. The
// factors are measured: with them a white surface sends back that share of the light.
struct Albedos {
    bool diffuse = false, phong = false, specular = false;
    void apply(Finish& finish) const {
        if (diffuse) finish.diffuse *= (finish.brilliance + 1) / 2;
        if (phong) finish.phong *= (finish.phong_size + 1) / 2;
        if (!specular || !(finish.roughness > 0)) return;
        const double exponent = 1 / finish.roughness;
        finish.specular *= (exponent + 2) / (4 * (2 - pow(2, -exponent / 2)));
    }
};

}  // namespace

// The word `albedo`, if it is next.
bool TextureParser::accept_albedo() {
    if (peek().kind != TokenKind::word || text_of(peek()) != "albedo") return false;
    take();
    return true;
}

void TextureParser::read_finish(Finish& finish) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    Albedos albedos;
    while (!failed() && !accept('}')) {
        const Token item = take();
        switch (item.word()) {
            case Word::k_ambient:
                finish.ambient = rgb_of(color(true));
                break;
            case Word::k_emission:
                finish.emission = rgb_of(color(true));
                break;
            case Word::k_diffuse:
                albedos.diffuse = accept_albedo() || albedos.diffuse;
                finish.diffuse = number();
                finish.diffuse_back = accept(',') || begins_number(peek()) ? number() : 0;
                break;
            case Word::k_brilliance:
                finish.brilliance = number();
                break;
            case Word::k_phong:
                albedos.phong = accept_albedo() || albedos.phong;
                finish.phong = number();
                break;
            case Word::k_phong_size:
                finish.phong_size = number();
                break;
            case Word::k_specular:
                albedos.specular = accept_albedo() || albedos.specular;
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
                finish.interior = make_counted<const Opaque>(Opaque{Word::k_interior, item, number()});
                break;
            default: {
                if (item.kind == TokenKind::word && text_of(item) == "refraction") {
                    finish.refraction = number();
                    break;
                }
                const auto held = named<Finish>(item);
                if (held == nullptr) {
                    return error(item, fmt::format("expected an item of a finish or `}}`, found {}{}",
                                                   describe(item), what_is(item)));
                }
                finish = *held;
                albedos = {};
            }
        }
        accept(',');
    }
    albedos.apply(finish);
}

// A color, or { [min,] max items }, after `reflection`.
void TextureParser::read_reflection(Finish& finish) {
    if (!peek().is('{')) {
        finish.reflection_min = finish.reflection_max = rgb_of(color(true));
        return;
    }
    take();
    bool is_fresnel = false;
    int colors = 0;
    while (!failed() && !accept('}')) {
        switch (peek().word()) {
            case Word::k_fresnel:
                take();
                finish.reflection_fresnel = is_fresnel = flag();
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
                if (++colors == 1) finish.reflection_min = finish.reflection_max;
        }
        accept(',');
    }
    if (is_fresnel && colors == 1) finish.reflection_min = {0, 0, 0};
}

}  // namespace glint::povray
