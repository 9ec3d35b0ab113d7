// SPDX-License-Identifier: Apache-2.0
// light { } of glint's own language.
#include <fmt/format.h>

#include "formats/field_keys.h"
#include "formats/glint_blocks.h"
#include "scene/light_fields.h"

namespace glint {
namespace {

// The keys: three that are not fields, then the fields.
enum { k_light_type, k_intensity, k_target };
const FieldKeys<Light>& light_keys() {
    static const FieldKeys<Light> keys({{"type"}, {"intensity"}, {"target"}}, k_light_fields);
    return keys;
}

constexpr SpellingHint k_light_hints[] = {{"pos", "`position`"},
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
                                          {"samples", "`samples_u` and `samples_v`"},
                                          {"normal", "`axis`"},
                                          {"kind", "`type`"}};

bool read_kind(GlintText& t, LightKind& kind) {
    std::string_view words[k_light_kinds];
    for (int k = 0; k < k_light_kinds; ++k) words[k] = to_string(static_cast<LightKind>(k));
    int index = 0;
    if (!t.p.choice(words, one_of(words), index)) return false;
    kind = static_cast<LightKind>(index);
    return true;
}

// The axis that is given by a target.
void aim_at(GlintText& t, Light& light, Vec3 target, const Token& token, bool has_axis) {
    if (has_axis)
        return t.p.error(token, fmt::format("expected `axis` or `target` in the {} light, found both",
                                            to_string(light.kind)));
    light.axis = target - light.position;
    if (is_zero(light.axis)) t.p.error(token, "expected a target other than the position of the light");
}

}  // namespace

std::span<const Field> glint_light_keys() { return light_keys().all(); }

void read_glint_light(GlintText& t, const Token& word) {
    const FieldKeys<Light>& keys = light_keys();
    FieldSet set("light", keys.all(), k_light_hints);
    std::string name = block_name(t);
    Light light;
    double intensity = 1;
    Vec3 target;
    Token key_tokens[k_max_keys];
    const auto errors = t.reading.diagnostics.error_count();
    const bool whole = t.blocks.fields(set, word, [&](int key, const Token& token) {
        key_tokens[key] = token;
        switch (key) {
            case k_light_type:
                return read_kind(t, light.kind);
            case k_intensity:
                return t.p.number(intensity, k_channel);
            case k_target:
                return read_point(t, target);
            default:
                return read_field(t, *keys.field(key), light);
        }
    });
    if (!whole || errors != t.reading.diagnostics.error_count()) return;  // the kind may be unknown
    const int position = keys.key_of(&Light::position), to_light = keys.key_of(&Light::to_light),
              direction = to_light + 1;
    const bool has_direction = set.has(to_light) || set.has(direction);
    if (set.has(to_light) && set.has(direction))
        t.p.error(key_tokens[direction],
                  "expected `to_light` or `direction`, which mean the same, found both");
    if (has_direction && !set.has(k_light_type) && !set.has(position))
        return t.p.error(word,
                         "expected `type = directional` in a light that has a direction and no position");
    const int axis = keys.key_of(&Light::axis);
    const bool is_aimed = light.has_axis() && set.has(k_target);
    if (is_aimed) aim_at(t, light, target, key_tokens[k_target], set.has(axis));
    for (const ItemField<Light>& field : k_light_fields) {
        if (is_aimed && is_field_of(field, &Light::axis)) continue;
        if (field.required && applies(field, light) && !keys.is_given(set, field))
            t.p.error(word, fmt::format("expected `{}` in the {} light", field.key, to_string(light.kind)));
    }
    for (int key = 0; key < static_cast<int>(keys.all().size()); ++key) {
        const ItemField<Light>* field = key == k_target ? keys.field(axis) : keys.field(key);
        if (field == nullptr || !set.has(key) || applies(*field, light)) continue;
        t.p.warn(key_tokens[key],
                 fmt::format("glint ignores the {} of {} light", t.p.describe(key_tokens[key]),
                             with_article(to_string(light.kind))));
    }
    if (!set.has(keys.key_of(&Light::specular_color))) light.specular_color = light.color;
    light.specular_color = light.specular_color * intensity;
    light.color = light.color * intensity;
    note(t.scene.light_texts, t.scene.lights.size(), source_place(t.text, word), std::move(name));
    t.scene.lights.push_back(light);
}

}  // namespace glint
