// SPDX-License-Identifier: Apache-2.0
// light { } of glint's own language.
#include <fmt/format.h>

#include "formats/glint_text.h"

namespace glint {
namespace {

enum { k_type, k_position, k_intensity, k_color, k_specular_color, k_to_light, k_direction, k_falloff };
constexpr Field k_fields[] = {{"type"},           {"position"}, {"intensity"}, {"color"},
                              {"specular_color"}, {"to_light"}, {"direction"}, {"attenuation"}};

constexpr SpellingHint k_hints[] = {{"pos", "`position`"},
                                    {"location", "`position`"},
                                    {"center", "`position`"},
                                    {"colour", "`color`"},
                                    {"rgb", "`color`"},
                                    {"diffuse", "`color`"},
                                    {"diffuse_color", "`color`"},
                                    {"specular", "`specular_color`"},
                                    {"ambient", "a light of its own: `light { type = ambient }`"},
                                    {"power", "`intensity`"},
                                    {"brightness", "`intensity`"},
                                    {"strength", "`intensity`"},
                                    {"falloff", "`attenuation = (c0, c1, c2)`"},
                                    {"kind", "`type`"}};

std::string_view with_article(LightKind kind) {
    return kind == LightKind::ambient ? "an ambient" : kind == LightKind::point ? "a point" : "a directional";
}

}  // namespace

void read_glint_light(GlintText& t, const Token& word) {
    FieldSet set("light", k_fields, k_hints);
    std::string name = block_name(t);
    Light light;
    Color specular_color;
    double intensity = 1;
    Token keys[std::size(k_fields)];
    const auto errors = t.reading.diagnostics.error_count();
    const bool whole = t.blocks.fields(set, word, [&](int field, const Token& key) {
        keys[field] = key;
        switch (field) {
            case k_type: {
                static constexpr std::string_view words[] = {"ambient", "point", "directional"};
                int index = 0;
                if (!t.p.choice(words, "`ambient`, `point` or `directional`", index)) return false;
                light.kind = static_cast<LightKind>(index);
                return true;
            }
            case k_position:
                return read_point(t, light.position);
            case k_intensity:
                return t.p.number(intensity, k_channel);
            case k_color:
                return read_color(t, light.color, k_channel, ColorUse::light);
            case k_specular_color:
                return read_color(t, specular_color, k_channel, ColorUse::light);
            case k_falloff: {
                double c[3] = {};
                if (!t.p.triple(c, glint::k_attenuation, '(', ')')) return false;
                light.attenuation = {c[0], c[1], c[2]};
                return true;
            }
            default:
                return read_direction(t, light.to_light);
        }
    });
    if (!whole || errors != t.reading.diagnostics.error_count()) return;  // of what kind it is may be unknown
    const bool has_direction = set.has(k_to_light) || set.has(k_direction);
    if (set.has(k_to_light) && set.has(k_direction))
        t.p.error(keys[k_direction], "expected `to_light` or `direction`, which mean the same, found both");
    if (has_direction && !set.has(k_type) && !set.has(k_position))
        return t.p.error(word,
                         "expected `type = directional` in a light that has a direction and no position");
    if (light.kind == LightKind::point && !set.has(k_position))
        t.p.error(word, "expected `position` in the point light");
    if (light.kind == LightKind::directional && !has_direction)
        t.p.error(word, "expected `to_light` in the directional light");
    const auto warn_unused = [&](int field, bool is_used) {
        if (!set.has(field) || is_used) return;
        t.p.warn(keys[field], fmt::format("glint ignores the {} of {} light", t.p.describe(keys[field]),
                                          with_article(light.kind)));
    };
    warn_unused(k_position, light.kind == LightKind::point);
    warn_unused(k_falloff, light.kind == LightKind::point);
    warn_unused(k_to_light, light.kind == LightKind::directional);
    warn_unused(k_direction, light.kind == LightKind::directional);
    warn_unused(k_specular_color, light.kind != LightKind::ambient);
    light.specular_color = (set.has(k_specular_color) ? specular_color : light.color) * intensity;
    light.color = light.color * intensity;
    note(t.scene.light_texts, t.scene.lights.size(), source_place(t.text, word), std::move(name));
    t.scene.lights.push_back(light);
}

}  // namespace glint
