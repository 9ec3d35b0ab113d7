// SPDX-License-Identifier: Apache-2.0
// Finishes.
#include <fmt/format.h>

#include "formats/povray/texture_parser.h"
#include "math/elementary.h"

namespace glint::povray {

// The factors of `albedo` are measured: with them a white surface sends back that share of the light.
double Finish::brightest_diffuse() const { return diffuse_albedo ? diffuse * (brilliance + 1) / 2 : diffuse; }

double Finish::brightest_phong() const { return phong_albedo ? phong * (phong_size + 1) / 2 : phong; }

double Finish::brightest_specular() const {
    if (!specular_albedo || !(roughness > 0)) return specular;
    const double exponent = 1 / roughness;
    return specular * (exponent + 2) / (4 * (2 - pow(2, -exponent / 2)));
}

void TextureParser::read_finish(Finish& finish) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
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
void TextureParser::read_reflection(Finish& finish) {
    if (!peek().is('{')) {
        finish.reflection_min = finish.reflection_max = rgb_of(color(true));
        return;
    }
    take();
    bool has_min = false;
    while (!failed() && !accept('}')) {
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

}  // namespace glint::povray
