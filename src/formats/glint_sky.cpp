// SPDX-License-Identifier: Apache-2.0
// occlusion { } and background_gradient { } of glint's own language.
#include <fmt/format.h>

#include <type_traits>

#include "formats/field_keys.h"
#include "formats/glint_blocks.h"
#include "formats/glint_color_map.h"
#include "scene/sky_fields.h"

namespace glint {
namespace {

enum { k_word, k_color_map };  // the key `method` or `type`; only of the gradient

const FieldKeys<Occlusion>& occlusion_keys() {
    static const FieldKeys<Occlusion> keys({{"method"}}, k_occlusion_fields);
    return keys;
}
const FieldKeys<BackgroundGradient>& gradient_keys() {
    static const FieldKeys<BackgroundGradient> keys({{"type"}, {"color_map"}}, k_gradient_fields);
    return keys;
}

constexpr SpellingHint k_occlusion_hints[] = {{"colour", "`color`"},    {"type", "`method`"},
                                              {"distance", "`reach`"},  {"max_distance", "`reach`"},
                                              {"intensity", "`color`"}, {"rescale", "`direct`"}};
constexpr SpellingHint k_gradient_hints[] = {{"colour", "`bottom_color` and `top_color`"},
                                             {"color", "`bottom_color` and `top_color`"},
                                             {"bottom_colour", "`bottom_color`"},
                                             {"top_colour", "`top_color`"},
                                             {"kind", "`type`"},
                                             {"repeat", "`repeats`"}};

// One of two words, of which to_string() has the text.
template <class Word> bool read_word(GlintText& t, Word& word) {
    const std::string_view words[] = {to_string(Word{0}), to_string(Word{1})};
    int index = 0;
    if (!t.p.choice(words, one_of(words), index)) return false;
    word = static_cast<Word>(index);
    return true;
}

// A block that a scene has at most once. Returns the place of `key_at` if it is given.
template <class Item, class Word>
bool read_once(GlintText& t, const Token& word, std::string_view name, const FieldKeys<Item>& keys,
               std::span<const SpellingHint> hints, Word Item::*kind, std::optional<Item>& to,
               Token* tokens) {
    FieldSet set(name, keys.all(), hints);
    Item item;
    const auto errors = t.reading.diagnostics.error_count();
    const bool whole = t.blocks.fields(set, word, [&](int key, const Token& token) {
        tokens[key] = token;
        if (key == k_word) return read_word(t, item.*kind);
        if constexpr (std::is_same_v<Item, BackgroundGradient>) {
            if (key == k_color_map) return read_color_map(t, token, false, item.color_map);
        }
        return read_field(t, *keys.field(key), item);
    });
    if (!whole || errors != t.reading.diagnostics.error_count()) return false;
    if (to) t.p.warn(word, fmt::format("a second {}: the last one holds", name));
    to = item;
    return true;
}

}  // namespace

std::span<const Field> glint_occlusion_keys() { return occlusion_keys().all(); }
std::span<const Field> glint_gradient_keys() { return gradient_keys().all(); }

void read_glint_occlusion(GlintText& t, const Token& word) {
    Token tokens[k_max_keys];
    if (read_once(t, word, "occlusion", occlusion_keys(), k_occlusion_hints, &Occlusion::method,
                  t.scene.occlusion, tokens))
        t.scene.occlusion_place = source_place(t.text, word);
}

void read_glint_gradient(GlintText& t, const Token& word) {
    Token tokens[k_max_keys];
    for (Token& token : tokens) token = word;
    if (!read_once(t, word, "background_gradient", gradient_keys(), k_gradient_hints,
                   &BackgroundGradient::kind, t.scene.gradient, tokens))
        return;
    t.scene.gradient_place = source_place(t.text, word);
    const BackgroundGradient& gradient = *t.scene.gradient;
    if (gradient.top > gradient.bottom) return;
    const Token& top = tokens[gradient_keys().key_of(&BackgroundGradient::top)];
    t.p.error(top.offset != word.offset ? top : tokens[gradient_keys().key_of(&BackgroundGradient::bottom)],
              fmt::format("expected a `top` above the bottom {}, found {}", gradient.bottom, gradient.top));
}

}  // namespace glint
