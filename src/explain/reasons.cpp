// SPDX-License-Identifier: Apache-2.0
// The reasons why a light adds light or not.
#include <array>

#include "glint/explain.h"
#include "scene/material_color.h"

namespace glint {
namespace {

template <class Word, std::size_t n>
std::string_view word_of(Word value, const std::array<std::string_view, n>& words) {
    const auto i = static_cast<std::size_t>(value);
    return i < n ? words[i] : "unknown";
}

bool is_black(Color a, Color b) { return a.r * b.r == 0 && a.g * b.g == 0 && a.b * b.b == 0; }

}  // namespace

LightReason reason(const LightTerms& terms) {
    if (terms.blocked) return LightReason::blocked;
    if (terms.may_add) return LightReason::adds;
    if (!(terms.distance > 0)) return LightReason::in_surface;
    if (!(terms.attenuation > 0)) return LightReason::faded;
    if (!(terms.spot > 0)) return LightReason::outside_cone;
    if (!(terms.emitter > 0)) return LightReason::back_of_light;
    if (terms.n_l > 0 && terms.n_l * (terms.attenuation * terms.spot * terms.emitter) <= terms.threshold)
        return LightReason::faint;
    return terms.n_l > 0 ? LightReason::no_color : LightReason::behind;
}

HighlightReason highlight_reason(const LightTerms& terms, const ExplainedHit& hit, const Scene& scene) {
    if (scene.settings.shading != Shading::phong && scene.settings.shading != Shading::blinn_phong)
        return HighlightReason::unshaded;
    if (terms.light >= scene.lights.size()) return HighlightReason::none;
    const Material& material = material_of(hit, scene);
    const Color white{1, 1, 1};
    if (is_black(material.specular,
                 material.tinted_highlight ? scene.lights[terms.light].specular_color : white))
        return HighlightReason::none;
    const Conventions& rules = scene.conventions;
    if (rules.specular_gate && !(terms.n_l > 0)) return HighlightReason::behind;
    if (rules.clamp_cosines ? !(terms.s > 0) : terms.s == 0) return HighlightReason::turned_away;
    return HighlightReason::adds;
}

Material material_of(const ExplainedHit& hit, const Scene& scene) {
    Material material = hit.material < scene.materials.size() ? scene.materials[hit.material] : Material{};
    if (hit.color) material = with_color(material, *hit.color);
    if (!hit.texture || hit.texture->texture >= scene.textures.size()) return material;
    const ExplainedTexture& shown = *hit.texture;
    return with_texture(material, scene.textures[shown.texture],
                        {shown.color, shown.ambient, shown.diffuse, shown.alpha});
}

std::string_view to_string(LightReason reason) {
    constexpr std::array<std::string_view, 9> words = {"adds",         "blocked", "behind",
                                                       "no_color",     "faded",   "in_surface",
                                                       "outside_cone", "faint",   "back_of_light"};
    return word_of(reason, words);
}

std::string_view to_string(HighlightReason reason) {
    constexpr std::array<std::string_view, 5> words = {"adds", "none", "unshaded", "behind", "turned_away"};
    return word_of(reason, words);
}

std::string_view to_string(SecondaryRayState state) {
    constexpr std::array<std::string_view, 5> words = {"none", "traced", "limit", "faint", "cut"};
    return word_of(state, words);
}

}  // namespace glint
