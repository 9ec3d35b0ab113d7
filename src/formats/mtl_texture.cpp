// SPDX-License-Identifier: Apache-2.0
#include "formats/mtl_texture.h"

#include <algorithm>

#include "formats/texture_file.h"
#include "scene/ranges.h"

namespace glint {
namespace {

struct MapOption {
    std::string_view word;
    int least, most;  // of its values
};
constexpr MapOption k_map_options[] = {
    {"-blendu", 1, 1}, {"-blendv", 1, 1},  {"-boost", 1, 1}, {"-bm", 1, 1}, {"-cc", 1, 1},
    {"-clamp", 1, 1},  {"-imfchan", 1, 1}, {"-mm", 2, 2},    {"-o", 1, 3},  {"-s", 1, 3},
    {"-t", 1, 3},      {"-texres", 1, 1},  {"-type", 1, 1}};

const MapOption* map_option(std::string_view word) {
    for (const MapOption& option : k_map_options) {
        if (option.word == word) return &option;
    }
    return nullptr;
}

constexpr std::string_view k_without_map = "its surfaces are drawn without it";

std::shared_ptr<const TextureImage> image_of(LoadState& reading, const MtlMap& map, std::string& path) {
    const ReadText from{reading.texts[map.file], map.file, true};
    return texture_image_of_file(reading, from, map.at, map.name, path, k_without_map);
}

// The word of an 8-bit or 16-bit texel as one of another size, which is not smaller.
template <class Word, class From> Word scaled(From word) {
    return sizeof(From) == sizeof(Word) ? static_cast<Word>(word) : static_cast<Word>(word * 257);
}

// The opacity in a texel: its alpha, else the mean of its channels.
template <class Word> Word opacity_of(const Word* texel, bool has_alpha) {
    if (has_alpha) return texel[3];
    return static_cast<Word>((texel[0] + texel[1] + texel[2]) / 3);
}

template <class Word>
std::vector<Word> words_with_opacity(const TextureImage* color, const TextureImage& opacity) {
    const std::size_t count = std::size_t{opacity.width} * opacity.height;
    std::vector<Word> words(4 * count, static_cast<Word>(-1));
    const auto each_texel = [&](const TextureImage& image, const auto& use) {
        std::visit(
            [&](const auto& from) {
                for (std::size_t i = 0; i < count; ++i)
                    use(&words[4 * i], from.data() + image.channels() * i);
            },
            image.words);
    };
    if (color != nullptr)
        each_texel(*color, [](Word* to, const auto* from) {
            for (int c = 0; c < 3; ++c) to[c] = scaled<Word>(from[c]);
        });
    each_texel(opacity, [&](Word* to, const auto* from) {
        to[3] = scaled<Word>(opacity_of(from, opacity.has_alpha));
    });
    return words;
}

// The colors of one image, white without one, with the opacity of another of the same size. Null, after an
// error, if the memory has no room for it.
std::shared_ptr<const TextureImage> with_opacity(LoadState& reading, const TextureImage* color,
                                                 const TextureImage& opacity, const MtlMap& map) {
    std::shared_ptr<const TextureImage>& known = reading.faded_images[{color, &opacity}];
    if (known) return known;
    const bool is_long = opacity.words.index() == 1 || (color != nullptr && color->words.index() == 1);
    const std::uint64_t bytes = std::uint64_t{opacity.width} * opacity.height * (is_long ? 8 : 4);
    if (bytes > reading.memory.room()) {
        reading.diagnostics.error(reading.texts[map.file], map.at.offset, map.at.length,
                                  reading.memory.message());
        return nullptr;
    }
    reading.memory.add(bytes);
    TextureImage made{opacity.width, opacity.height, true, {}};
    if (is_long) {
        made.words = words_with_opacity<std::uint16_t>(color, opacity);
    } else {
        made.words = words_with_opacity<std::uint8_t>(color, opacity);
    }
    return known = std::make_shared<const TextureImage>(std::move(made));
}

}  // namespace

std::string read_mtl_map(LineWords& words, std::uint16_t file, MtlMap& map) {
    double scale[2] = {1, 1}, offset[2] = {0, 0};
    std::string_view word = words.next();
    while (const MapOption* const option = map_option(word)) {
        word = words.next();
        for (int i = 0; i < option->most; ++i) {
            double number = 0;
            const bool is_number = read_number_word(word, number) && k_coordinate.contains(number);
            if (i >= option->least && !is_number) break;
            if (word.empty()) return "a value of the option";
            if (option->word == "-clamp") map.clamps = word == "on";
            if (option->word == "-o" || option->word == "-s") {
                if (!is_number) return std::string(k_coordinate.text);
                if (i < 2) (option->word == "-o" ? offset : scale)[i] = number;
            }
            word = words.next();
        }
    }
    if (word.empty()) return "the name of a picture's file";
    map.name = std::string(words.rest_from_word());
    std::replace(map.name.begin(), map.name.end(), '\\', '/');
    map.at.offset = words.start();
    map.at.length = words.length();
    map.file = file;
    map.uv_map = {{{scale[0], 0, offset[0]}, {0, scale[1], offset[1]}}};
    return {};
}

std::optional<Texture> mtl_texture(LoadState& reading, const std::optional<MtlMap>& color,
                                   const std::optional<MtlMap>& opacity) {
    Texture texture;
    std::string opacity_path;
    std::shared_ptr<const TextureImage> colors, opacities;
    if (color) colors = image_of(reading, *color, texture.file);
    if (opacity) opacities = image_of(reading, *opacity, opacity_path);
    const MtlMap& placed = colors ? *color : opacities ? *opacity : MtlMap{};
    if (!colors && !opacities) return std::nullopt;
    texture.alpha = opacities ? TextureAlpha::blend : TextureAlpha::ignore;
    texture.uv_map = placed.uv_map;
    if (placed.clamps) texture.wrap_u = texture.wrap_v = TextureWrap::clamp;
    texture.image = colors;
    if (!opacities || (opacities == colors && colors->has_alpha)) return texture;
    if (colors && (colors->width != opacities->width || colors->height != opacities->height)) {
        reading.diagnostics.warn(reading.texts[opacity->file], opacity->at.offset, opacity->at.length,
                                 "expected a picture of the size of map_Kd's; " + std::string(k_without_map));
        texture.alpha = TextureAlpha::ignore;
        return texture;
    }
    texture.file.clear();
    texture.image = with_opacity(reading, colors.get(), *opacities, *opacity);
    if (!texture.image) return std::nullopt;
    return texture;
}

}  // namespace glint
