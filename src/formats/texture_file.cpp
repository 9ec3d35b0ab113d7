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

std::string wrong_name(const std::string& name) {
    return fmt::format("{}: expected the name of a file that ends in {}", quoted(name),
                       one_of(k_picture_extensions));
}

// report(what) tells what is wrong with the file.
template <class Report>
std::shared_ptr<const TextureImage> image_of_text(LoadState& reading, const ReadText& text, std::string& path,
                                                  const Report& report) {
    path = reading.scene.files[text.file];
    if (const auto known = reading.texture_images.find(text.file); known != reading.texture_images.end())
        return known->second;
    std::string why;
    auto image = decode_texture_image(reading, text.place.text, why);
    if (!image) report(why);
    reading.texture_images.emplace(text.file, image);
    return image;
}

}  // namespace

std::shared_ptr<const TextureImage> texture_image_of_file(LoadState& reading, const ReadText& from,
                                                          const Token& at, const std::string& name,
                                                          std::string& path) {
    if (!is_picture_name(name)) {
        reading.diagnostics.error(from.place, at.offset, at.length, wrong_name(name));
        return nullptr;
    }
    const auto text = open_text(reading, from, at, name);
    if (!text) return nullptr;
    return image_of_text(reading, *text, path, [&](const std::string& why) {
        reading.diagnostics.error(from.place, at.offset, at.length, fmt::format("{}: {}", quoted(name), why));
    });
}

std::shared_ptr<const TextureImage> optional_texture_image(LoadState& reading, const ReadText& from,
                                                           const Token& at, const std::string& name,
                                                           std::string& path, std::string_view without) {
    if (!is_picture_name(name)) {
        reading.diagnostics.warn(from.place, at.offset, at.length,
                                 fmt::format("{}; {}", wrong_name(name), without));
        return nullptr;
    }
    const auto text = open_optional_text(reading, from, at, name, without);
    if (!text) return nullptr;
    return image_of_text(reading, *text, path, [&](const std::string& why) {
        reading.diagnostics.warn(from.place, at.offset, at.length,
                                 fmt::format("{}: {}; {}", quoted(name), why, without));
    });
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
