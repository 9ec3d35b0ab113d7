// SPDX-License-Identifier: Apache-2.0
#include "formats/texture_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/include.h"
#include "image/texture_image.h"

namespace glint {
namespace {

bool is_picture_name(std::string_view name) {
    const auto ends_with = [&](std::string_view extension) {
        if (name.size() < extension.size()) return false;
        const std::string_view end = name.substr(name.size() - extension.size());
        return std::equal(end.begin(), end.end(), extension.begin(), [](char c, char lower) {
            return (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) == lower;
        });
    };
    return std::any_of(std::begin(k_picture_extensions), std::end(k_picture_extensions), ends_with);
}

}  // namespace

std::shared_ptr<const TextureImage> texture_image_of_file(LoadState& reading, const ReadText& from,
                                                          const Token& at, const std::string& name,
                                                          std::string& path, std::string_view without) {
    const auto report = [&](std::string_view what) {
        if (without.empty()) {
            reading.diagnostics.error(from.place, at.offset, at.length,
                                      fmt::format("{}: {}", quoted(name), what));
        } else {
            reading.diagnostics.warn(from.place, at.offset, at.length,
                                     fmt::format("{}: {}; {}", quoted(name), what, without));
        }
    };
    if (!is_picture_name(name)) {
        report(fmt::format("expected the name of a file that ends in {}", one_of(k_picture_extensions)));
        return nullptr;
    }
    const auto text = without.empty() ? open_text(reading, from, at, name)
                                      : open_optional_text(reading, from, at, name, without);
    if (!text) return nullptr;
    path = reading.scene.files[text->file];
    const auto [known, is_new] = reading.texture_images.try_emplace(text->file);
    if (!is_new) return known->second;
    std::string why;
    known->second = decode_texture_image(reading, text->place.text, why);
    if (!known->second) report(why);
    return known->second;
}

std::shared_ptr<const TextureImage> decode_texture_image(LoadState& reading, std::string_view bytes,
                                                         std::string& why) {
    DecodeOptions options;
    options.max_memory = reading.memory.room();
    Result<TextureImage> image =
        decode_texture({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, options);
    if (!image) {
        why = image.message;
        return nullptr;
    }
    reading.memory.add(
        std::visit([](const auto& words) { return words.size() * sizeof(words[0]); }, image->words));
    return std::make_shared<const TextureImage>(std::move(*image));
}

}  // namespace glint
