// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/textures.h"

#include <cmath>
#include <cstddef>
#include <variant>

#include "image/encoders.h"
#include "math/elementary.h"
#include "math/number.h"
#include "math/srgb.h"

namespace glint::gltf_export {
namespace {

// The numbers of OpenGL that samplers have.
constexpr int k_nearest = 9728, k_linear = 9729, k_linear_mipmaps = 9987;
constexpr int k_repeat = 10497, k_clamp = 33071, k_mirror = 33648;

int wrap_number(TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return k_repeat;
        case TextureWrap::mirror:
            return k_mirror;
        case TextureWrap::clamp:
        case TextureWrap::once:
        case TextureWrap::clip:
            break;
    }
    return k_clamp;
}

#ifdef GLINT_WITH_PNG
std::uint8_t to_word(double value) {
    return static_cast<std::uint8_t>(std::floor(number::max(0.0, number::min(value, 1.0)) * 255 + 0.5));
}

// By word of the picture: the word of the file, whose words are decoded by the sRGB curve.
std::vector<std::uint8_t> word_table(std::size_t most, TextureEncoding encoding, const ColorRule& rule) {
    std::vector<std::uint8_t> words(most + 1);
    for (std::size_t word = 0; word <= most; ++word) {
        const double stored = static_cast<double>(word) / static_cast<double>(most);
        const bool is_srgb = encoding == TextureEncoding::srgb;
        // Without a difference of the two curves, the words stay.
        const bool stays = is_srgb ? rule.keeps_colors() : rule.is_plain();
        words[word] =
            to_word(stays ? stored : srgb_encode(rule.linear(is_srgb ? srgb_decode(stored) : stored)));
    }
    return words;
}

std::vector<std::uint8_t> png_of(const TextureImage& image, TextureEncoding encoding, const ColorRule& rule,
                                 bool with_alpha) {
    const std::size_t from = image.channels(), to = with_alpha ? 4 : 3;
    const std::size_t count = std::size_t{image.width} * image.height;
    std::vector<std::uint8_t> words(to * count);
    std::visit(
        [&](const auto& texels) {
            const std::size_t most = sizeof(texels[0]) == 1 ? 255 : 65535;
            const std::vector<std::uint8_t> table = word_table(most, encoding, rule);
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t c = 0; c < 3; ++c) words[to * i + c] = table[texels[from * i + c]];
                if (with_alpha)
                    words[to * i + 3] =
                        to_word(static_cast<double>(texels[from * i + 3]) / static_cast<double>(most));
            }
        },
        image.words);
    return encode_png_words(image.width, image.height, with_alpha, words);
}
#endif

}  // namespace

std::optional<UvTransform> transform_of(const UvMap& map) {
    const double a = map.m[0][0], b = map.m[0][1], d = map.m[1][0], f = map.m[1][1];
    UvTransform to;
    const double along = number::sqrt(a * a + d * d);
    if (!(along > 0)) return std::nullopt;
    const double c = a / along, s = d / along;
    const double across = s * b - c * f;
    // v that goes up would be a negative scale, which programs without the extension show upside down.
    if (!(across > 0)) return std::nullopt;
    constexpr double k_close = 1e-12;
    if (number::abs(s * across - b) > k_close * across || number::abs(-c * across - f) > k_close * across)
        return std::nullopt;
    to.scale[0] = along;
    to.scale[1] = across;
    to.rotation = d == 0 && a > 0 ? 0 : atan2(d, a);
    to.offset[0] = map.m[0][2];
    to.offset[1] = 1 - map.m[1][2];
    return to;
}

void TextureList::warn(const Texture& texture) {
    if (texture.has_wrap(TextureWrap::once) || texture.has_wrap(TextureWrap::clip))
        losses_.add("textures with the wrap `once` or `clip`", "they are written as `clamp`");
    if (texture.ambient != 1 || texture.diffuse != 1)
        losses_.add("`ambient` and `diffuse` of textures", "they are left out");
    if (texture.over != k_none) losses_.add("textures over others", "the one in front is written");
    if (texture.filter == TextureFilter::distance)
        losses_.add("the filter `distance` of textures", "they are bilinear");
    if (texture.image->words.index() == 1)
        losses_.add("textures with 16 bits a channel that all programs read", "they are written with 8");
    if (texture.mapping != TextureMapping::uv)
        losses_.add("textures with a mapping other than `uv`",
                    "coordinates at the vertices of the meshes stand for it");
}

std::uint32_t TextureList::sampler(const Texture& texture) {
    const auto [known, is_new] =
        samplers_.try_emplace({texture.wrap_u, texture.wrap_v, texture.filter}, k_no_index);
    if (is_new) {
        const bool nearest = texture.filter == TextureFilter::nearest;
        known->second = file_.add(List::samplers, {{"magFilter", nearest ? k_nearest : k_linear},
                                                   {"minFilter", nearest ? k_nearest : k_linear_mipmaps},
                                                   {"wrapS", wrap_number(texture.wrap_u)},
                                                   {"wrapT", wrap_number(texture.wrap_v)}});
    }
    return known->second;
}

std::uint32_t TextureList::image(const Texture& texture) {
    const bool with_alpha = texture.has_alpha();
    const auto [known, is_new] =
        images_.try_emplace({texture.image.get(), texture.encoding, with_alpha}, k_no_index);
    if (!is_new) return known->second;
#ifdef GLINT_WITH_PNG
    const std::vector<std::uint8_t> png = png_of(*texture.image, texture.encoding, rule_, with_alpha);
    known->second = file_.add(List::images, {{"mimeType", "image/png"}, {"bufferView", file_.add_view(png)}});
#else
    losses_.add("textures without PNG, which this build of glint lacks", "they are left out");
#endif
    return known->second;
}

Json TextureList::info(std::uint32_t index) {
    const auto [known, is_new] = infos_.try_emplace(index);
    if (!is_new) return known->second;
    const Texture& texture = scene_.textures[index];
    const std::uint32_t picture = image(texture);
    if (picture == k_no_index) return known->second;
    warn(texture);
    const auto [number, is_new_texture] = textures_.try_emplace({picture, sampler(texture)}, k_no_index);
    if (is_new_texture) {
        Json item{{"sampler", number->first.second}, {"source", picture}};
        if (const std::string_view name = scene_.texture_texts.name(index); !name.empty())
            item["name"] = std::string(name);
        number->second = file_.add(List::textures, item);
    }
    Json& info = known->second;
    info = {{"index", number->second}};
    const std::optional<UvTransform> transform = transform_of(texture.uv_map);
    if (texture.mapping == TextureMapping::uv && transform && !transform->is_identity()) {
        Json to = Json::object();
        if (transform->offset[0] != 0 || transform->offset[1] != 0)
            to["offset"] = {transform->offset[0], transform->offset[1]};
        if (transform->rotation != 0) to["rotation"] = transform->rotation;
        if (transform->scale[0] != 1 || transform->scale[1] != 1)
            to["scale"] = {transform->scale[0], transform->scale[1]};
        info["extensions"] = {{"KHR_texture_transform", std::move(to)}};
        file_.use_extension("KHR_texture_transform");
    }
    return info;
}

}  // namespace glint::gltf_export
