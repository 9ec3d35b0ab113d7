// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/text.h"
#include "formats/texture_file.h"
#include "math/elementary.h"
#include "scene/fields.h"
#include "scene/ranges.h"

namespace glint::gltf {
namespace {

constexpr std::string_view k_without = "its surfaces are drawn without it";

// The numbers of OpenGL that samplers have.
constexpr std::uint64_t k_nearest = 9728, k_repeat = 10497, k_clamp = 33071, k_mirror = 33648;

// The sums are exact.
Color mean_of(const TextureImage& image) {
    return std::visit(
        [&](const auto& words) {
            std::uint64_t sums[3] = {0, 0, 0};
            for (std::size_t i = 0; i < words.size(); i += image.channels()) {
                for (std::size_t c = 0; c < 3; ++c) sums[c] += words[i + c];
            }
            const double whole =
                static_cast<double>(std::numeric_limits<std::decay_t<decltype(words[0])>>::max()) *
                image.width * image.height;
            const auto share = [&](std::uint64_t sum) { return static_cast<double>(sum) / whole; };
            return Color{share(sums[0]), share(sums[1]), share(sums[2])};
        },
        image.words);
}

}  // namespace

bool Textures::read_wrap(JsonValue sampler, std::string_view key, TextureWrap& wrap) {
    std::uint64_t mode = k_repeat;
    if (!file_.whole(sampler, key, mode)) return false;
    if (mode != k_repeat && mode != k_clamp && mode != k_mirror)
        return file_.expected(sampler.find(key), "10497, 33071 or 33648", key);
    wrap = mode == k_repeat  ? TextureWrap::repeat
           : mode == k_clamp ? TextureWrap::clamp
                             : TextureWrap::mirror;
    return true;
}

bool Textures::read_sampler(JsonValue texture, Texture& to) {
    const JsonValue value = texture.find("sampler");
    if (!value.exists()) return true;
    const std::optional<std::uint32_t> index = file_.index(value, List::samplers);
    if (!index) return false;
    const JsonValue sampler = file_.item(List::samplers, *index);
    std::uint64_t filter = 0;
    if (!file_.whole(sampler, "magFilter", filter)) return false;
    to.filter = filter == k_nearest ? TextureFilter::nearest : TextureFilter::bilinear;
    return read_wrap(sampler, "wrapS", to.wrap_u) && read_wrap(sampler, "wrapT", to.wrap_v);
}

// KHR_texture_transform: (u, v) is scaled, then rotated counter-clockwise as seen in the picture, then moved.
// v goes down in glTF, and up in glint.
bool Textures::read_place(JsonValue info, Texture& to, TextureUse& use) {
    const JsonValue transform = File::extension(info, "KHR_texture_transform");
    double offset[2] = {0, 0}, scale[2] = {1, 1}, rotation = 0;
    constexpr Range angle{-1e5, 1e5, false, false, "a number from -1e5 to 1e5"};
    std::uint64_t set = 0;
    if (!file_.numbers(transform, "offset", offset, k_channel) ||
        !file_.numbers(transform, "scale", scale, k_channel) ||
        !file_.number(transform, "rotation", rotation, angle) || !file_.whole(info, "texCoord", set) ||
        !file_.whole(transform, "texCoord", set))
        return false;
    if (set > 255) return file_.error(info, "expected a `texCoord` from 0 to 255");
    use.set = static_cast<std::uint32_t>(set);
    const double c = cos(rotation), s = sin(rotation);
    to.uv_map = {{{c * scale[0], s * scale[1], offset[0]}, {s * scale[0], -(c * scale[1]), 1 - offset[1]}}};
    return true;
}

std::shared_ptr<const TextureImage> Textures::decoded(JsonValue image, std::string_view bytes) {
    std::string why;
    auto texels = decode_texture_image(file_.reading, bytes, why);
    if (!texels) file_.warn(image, fmt::format("{}; {}", why, k_without));
    return texels;
}

// False after an error. A picture that cannot be read is a warning.
bool Textures::read_picture(JsonValue image, Picture& picture) {
    if (const JsonValue view = image.find("bufferView"); view.exists()) {
        const std::optional<BufferView> found = buffers_.view(view);
        if (found) picture.texels = decoded(image, found->bytes);
        return found.has_value();
    }
    const JsonValue uri = image.find("uri");
    if (!uri.is(JsonKind::string))
        return file_.expected(uri.exists() ? uri : image, "a `uri` or a `bufferView` of the image");
    if (is_data_uri(uri.text().substr(1))) {
        const std::optional<std::string_view> bytes = buffers_.decode(uri);
        if (bytes) picture.texels = decoded(uri, *bytes);
        return bytes.has_value();
    }
    std::string why;
    const std::optional<std::string> file = file_of_uri(uri.string(), why);
    if (!file) {
        file_.warn(uri, fmt::format("{}: {}; {}", quoted(uri.string()), why, k_without));
        return true;
    }
    picture.texels =
        texture_image_of_file(file_.reading, file_.text, file_.token(uri), *file, picture.file, k_without);
    return true;
}

Textures::Picture* Textures::picture(JsonValue source) {
    const std::optional<std::uint32_t> index = file_.index(source, List::images);
    if (!index) return nullptr;
    const auto [found, is_new] = pictures_.try_emplace(*index);
    if (!is_new) return &found->second;
    return read_picture(file_.item(List::images, *index), found->second) ? &found->second : nullptr;
}

std::optional<Textures::Source> Textures::source(JsonValue info) {
    const JsonValue number = info.find("index");
    if (!number.exists()) {
        file_.expected(info, "an object with the `index` of a texture");
        return std::nullopt;
    }
    const std::optional<std::uint32_t> index = file_.index(number, List::textures);
    if (!index) return std::nullopt;
    const JsonValue at = file_.item(List::textures, *index);
    const Source source{*index, at.find("source")};
    if (!source.image.exists()) {
        file_.warn_once("gltf source", at,
                        fmt::format("{} has no `source`, a picture that glint reads: {}",
                                    File::name(List::textures, *index), k_without));
    }
    return source;
}

std::optional<Color> Textures::mean(JsonValue info) {
    const std::optional<Source> source = this->source(info);
    if (!source || !source->image.exists()) return std::nullopt;
    Picture* const found = picture(source->image);
    if (found == nullptr || !found->texels) return std::nullopt;
    if (!found->mean) found->mean = mean_of(*found->texels);
    return found->mean;
}

std::optional<TextureUse> Textures::use(JsonValue info, TextureAlpha alpha, double cutoff, TextureMix mix) {
    const std::optional<Source> source = this->source(info);
    if (!source) return std::nullopt;
    const JsonValue at = file_.item(List::textures, source->texture);
    Texture texture;
    TextureUse use;
    if (!read_place(info, texture, use) || !read_sampler(at, texture)) return std::nullopt;
    if (!source->image.exists()) return use;
    const Picture* const found = picture(source->image);
    if (found == nullptr) return std::nullopt;
    if (!found->texels) return use;
    texture.image = found->texels;
    texture.file = found->file;
    texture.encoding = TextureEncoding::srgb;
    texture.alpha = alpha;
    texture.mix = mix;
    if (alpha == TextureAlpha::mask) texture.alpha_cutoff = cutoff;
    std::vector<Texture>& all = file_.reading.scene.textures;
    const TextureKey key{source->texture, alpha, mix, texture.alpha_cutoff, numbers_of(texture.uv_map)};
    const auto [known, is_new] = textures_.try_emplace(key, static_cast<std::uint32_t>(all.size()));
    if (is_new) {
        all.push_back(std::move(texture));
        note(file_.reading.scene.texture_texts, known->second, file_.place(at), file_.string(at, "name"));
    }
    use.texture = known->second;
    return use;
}

}  // namespace glint::gltf
