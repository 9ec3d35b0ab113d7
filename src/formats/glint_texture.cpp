// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_texture.h"

#include <fmt/format.h>

#include <optional>

#include <algorithm>
#include <array>

#include "formats/glint_blocks.h"
#include "formats/glint_color_map.h"
#include "formats/glint_item.h"
#include "formats/texture_file.h"
#include "math/transform.h"
#include "scene/texture_fields.h"

namespace glint {
namespace {

enum { k_texture_file, k_texture_texels, k_texture_color_map, k_first_texture_field };
constexpr int k_first_texture_map = k_first_texture_field + static_cast<int>(std::size(k_texture_fields));

constexpr auto k_texture_keys = [] {
    std::array<Field, k_first_texture_map + std::size(k_transform_fields)> keys{
        {{"file"}, {"texels"}, {"color_map"}}};
    auto* key = keys.data() + k_first_texture_field;
    for (const ItemField<Texture>& field : k_texture_fields) *key++ = {field.key};
    std::copy(std::begin(k_transform_fields), std::end(k_transform_fields), key);
    return keys;
}();

constexpr SpellingHint k_texture_hints[] = {{"image", "`file`"},         {"map", "`file`"},
                                            {"picture", "`file`"},       {"wrap", "`wrap_u` and `wrap_v`"},
                                            {"projection", "`mapping`"}, {"interpolate", "`filter`"},
                                            {"gamma", "`encoding`"},     {"colors", "`color_map`"},
                                            {"pattern", "`mapping`"}};

constexpr std::string_view k_texel_words =
    "a word of 6, 8, 12 or 16 hexadecimal digits for each texel, as many in all";

// The rows of a list of texels.
class TexelRows {
  public:
    /// Adds a row. What was expected instead, or an empty string.
    std::string add(std::string_view row) {
        std::uint32_t width = 0;
        while (true) {
            row.remove_prefix(std::min(row.find_first_not_of(" \t"), row.size()));
            if (row.empty()) break;
            const std::string_view word = row.substr(0, row.find_first_of(" \t"));
            row.remove_prefix(word.size());
            if (digits_ == 0) digits_ = word.size();
            const bool is_word = digits_ == 6 || digits_ == 8 || digits_ == 12 || digits_ == 16;
            if (!is_word || word.size() != digits_) return std::string(k_texel_words);
            for (std::size_t i = 0; i < digits_; i += channel_digits()) {
                std::uint32_t value = 0;
                for (std::size_t k = 0; k < channel_digits(); ++k) {
                    const int digit = hex_digit(word[i + k]);
                    if (digit < 0) return std::string(k_texel_words);
                    value = value * 16 + static_cast<std::uint32_t>(digit);
                }
                words_.push_back(static_cast<std::uint16_t>(value));
            }
            ++width;
        }
        if (width == 0 || width > k_max_texture_size) return "1 to 32768 texels in a row";
        if (height_ != 0 && width != width_) return fmt::format("{} texels, as in the first row", width_);
        if (height_ == k_max_texture_size) return "at most 32768 rows";
        width_ = width;
        ++height_;
        return {};
    }
    std::shared_ptr<const TextureImage> image() const {
        if (height_ == 0) return nullptr;
        auto made = std::make_shared<TextureImage>();
        made->width = width_;
        made->height = height_;
        made->has_alpha = digits_ % 8 == 0;
        if (digits_ > 8) {
            made->words = words_;
        } else {
            made->words = std::vector<std::uint8_t>(words_.begin(), words_.end());
        }
        return made;
    }

  private:
    std::size_t channel_digits() const { return digits_ > 8 ? 4 : 2; }

    std::size_t digits_ = 0;  // of a texel
    std::uint32_t width_ = 0, height_ = 0;
    std::vector<std::uint16_t> words_;
};

// Reads the list of `texels`: a string for each row, from the top. Null after an error.
std::shared_ptr<const TextureImage> read_texels(GlintText& t) {
    TexelRows rows;
    const auto errors = t.reading.diagnostics.error_count();
    const bool is_list = read_list(t, "a string for each row of texels", [&] {
        const Token at = t.p.token();
        if (at.kind != TokenKind::string) {
            t.p.expected("a row of texels in quotes");
            return false;
        }
        t.p.take();
        const std::string wrong = rows.add(t.p.name(at));
        if (!wrong.empty()) t.p.error(at, "expected " + wrong);
        return wrong.empty();
    });
    if (!is_list || errors != t.reading.diagnostics.error_count()) return nullptr;
    auto image = rows.image();
    if (!image) t.p.expected("at least one row of texels");
    return image;
}

}  // namespace

std::span<const Field> glint_texture_keys() { return k_texture_keys; }

GlintTextures& GlintTextures::of(LoadState& reading) {
    if (!reading.glint_textures) reading.glint_textures = std::make_shared<GlintTextures>();
    return *reading.glint_textures;
}

std::uint32_t GlintTextures::index_of(Scene& scene, const std::string& name) {
    const auto [at, is_new] = known_.emplace(name, static_cast<std::uint32_t>(scene.textures.size()));
    if (is_new) scene.textures.emplace_back();
    return at->second;
}

std::uint32_t GlintTextures::named(GlintText& t, const Token& name) {
    const std::string key = t.p.name(name);
    const bool is_new = !known_.contains(key);
    const std::uint32_t index = index_of(t.scene, key);
    if (is_new) undefined_.emplace(key, Use{t.text.place, name});
    return index;
}

void GlintTextures::read_block(GlintText& t, const Token& word) {
    if (!t.blocks.label() || t.p.name(*t.blocks.label()).empty()) {
        t.p.error(word, "expected a name after `texture`");
        return t.blocks.skip_block();
    }
    const Token name = *t.blocks.label();
    const std::string key = t.p.name(name);
    const auto known = known_.find(key);
    const bool is_second = known != known_.end() && !undefined_.contains(key);
    FieldSet set("texture", k_texture_keys, k_texture_hints);
    Texture texture;
    GlintItem item;
    int sources = 0;
    std::optional<Token> over;
    const bool whole = t.blocks.fields(set, word, [&](int field, const Token& at) {
        if (field == k_texture_file) {
            const Token file = t.p.token();
            if (file.kind != TokenKind::string) {
                t.p.expected("the name of a file in quotes");
                return false;
            }
            t.p.take();
            ++sources;
            texture.image = texture_image_of_file(t.reading, t.text, file, t.p.name(file), texture.file);
            return true;
        }
        if (field == k_texture_texels) {
            ++sources;
            texture.image = read_texels(t);
            return texture.image != nullptr;
        }
        if (field == k_texture_color_map) {
            ++sources;
            return read_color_map(t, at, true, texture.color_map);
        }
        if (field < k_first_texture_map &&
            is_field_of(k_texture_fields[field - k_first_texture_field], &Texture::over))
            return read_name(t, "the name of a texture", over.emplace());
        if (field < k_first_texture_map)
            return read_field(t, k_texture_fields[field - k_first_texture_field], texture);
        return read_transform_key(t, field - k_first_texture_map, at, item);
    });
    if (!whole) return;
    const SourcePlace place = source_place(t.text, word);
    if (is_second) {
        if (t.scene.texture_texts.place(known->second) == place) return;  // the file is included twice
        return t.p.error(name, fmt::format("a second texture called {}", quoted(key)));
    }
    if (sources != 1)
        return t.p.error(word,
                         sources == 0
                             ? "expected a texture's `file`, `texels` or `color_map`"
                             : "expected one of a texture's `file`, `texels` and `color_map`, found several");
    if (item.map) texture.world_from_texture = *item.map;
    const std::uint32_t index = index_of(t.scene, key);
    undefined_.erase(key);
    t.scene.textures[index] = std::move(texture);
    if (over) overs_.push_back({index, t.p.name(*over), {t.text.place, *over}});
    auto& texts = t.scene.texture_texts;
    if (texts.places.size() <= index) texts.places.resize(std::size_t{index} + 1);
    texts.places[index] = place;
    texts.names.emplace(index, key);
}

void GlintTextures::finish(LoadState& reading) {
    for (const Over& over : overs_) {
        const auto below = known_.find(over.name);
        if (below == known_.end()) {
            undefined_.emplace(over.name, over.use);
        } else {
            reading.scene.textures[over.texture].over = below->second;
        }
    }
    std::vector<std::string_view> names;
    for (const auto& [name, index] : known_) {
        if (!undefined_.contains(name)) names.push_back(name);
    }
    for (const auto& [name, use] : undefined_)
        reading.diagnostics.error(
            use.place, use.token.offset, use.token.length,
            fmt::format("no texture is called {}{}", quoted(name), did_you_mean(name, names)));
}

bool ValueReader::operator()(TextureType, std::uint32_t& texture) const {
    Token name;
    if (!read_name(t, "the name of a texture", name)) return false;
    texture = t.textures.named(t, name);
    return true;
}

bool ValueReader::operator()(UvMapType, UvMap& map) const {
    int row = 0;
    const Token at = t.p.token();
    const auto errors = t.reading.diagnostics.error_count();
    const bool is_list = read_list(t, "two rows `(a, b, c)`", [&] {
        if (row == 2) {
            t.p.expected("`)` after two rows");
            return false;
        }
        return t.p.numbers(map.m[row++], k_coordinate, '(', ')');
    });
    if (is_list && row < 2 && errors == t.reading.diagnostics.error_count())
        t.p.error(at, fmt::format("expected two rows `(a, b, c)`, found {}", row));
    return is_list;
}

}  // namespace glint
