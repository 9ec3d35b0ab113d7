// SPDX-License-Identifier: Apache-2.0
// fog { } of glint's own language.
#include <fmt/format.h>

#include "formats/field_keys.h"
#include "formats/glint_blocks.h"
#include "scene/fog_fields.h"

namespace glint {
namespace {

enum { k_fog_type };
const FieldKeys<Fog>& fog_keys() {
    static const FieldKeys<Fog> keys({{"type"}}, k_fog_fields);
    return keys;
}

constexpr SpellingHint k_fog_hints[] = {
    {"colour", "`color`"},  {"distance", "`density`, which is 1 / distance"},
    {"kind", "`type`"},     {"mode", "`type`"},
    {"near", "`start`"},    {"altitude", "`falloff`"},
    {"offset", "`height`"}, {"far", "`end`"}};

bool read_kind(GlintText& t, FogKind& kind) {
    constexpr FogKind kinds[] = {FogKind::linear, FogKind::exp, FogKind::exp2};
    std::string_view words[std::size(kinds)];
    for (const FogKind k : kinds) words[static_cast<int>(k)] = to_string(k);
    int index = 0;
    if (!t.p.choice(words, one_of(words), index)) return false;
    kind = static_cast<FogKind>(index);
    return true;
}

}  // namespace

std::span<const Field> glint_fog_keys() { return fog_keys().all(); }

void read_glint_fog(GlintText& t, const Token& word) {
    const FieldKeys<Fog>& keys = fog_keys();
    FieldSet set("fog", keys.all(), k_fog_hints);
    Fog fog;
    Token key_tokens[k_max_keys];
    const auto errors = t.reading.diagnostics.error_count();
    const bool whole = t.blocks.fields(set, word, [&](int key, const Token& token) {
        key_tokens[key] = token;
        return key == k_fog_type ? read_kind(t, fog.kind) : read_field(t, *keys.field(key), fog);
    });
    if (!whole || errors != t.reading.diagnostics.error_count()) return;
    for (int key = 0; key < static_cast<int>(keys.all().size()); ++key) {
        const ItemField<Fog>* field = keys.field(key);
        if (field == nullptr || !set.has(key) || applies(*field, fog)) continue;
        t.p.warn(key_tokens[key], fmt::format("glint ignores the {} of {} fog", t.p.describe(key_tokens[key]),
                                              with_article(to_string(fog.kind))));
    }
    if (fog.has_end() && !(fog.end > fog.start)) {
        const int end = keys.key_of(&Fog::end);
        t.p.error(set.has(end) ? key_tokens[end] : word,
                  fmt::format("expected an `end` above the start {}, found {}", fog.start, fog.end));
    }
    if (t.scene.fog) t.p.warn(word, "a second fog: the last one holds");
    t.scene.fog = fog;
    t.scene.fog_place = source_place(t.text, word);
}

}  // namespace glint
