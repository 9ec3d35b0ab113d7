// SPDX-License-Identifier: Apache-2.0
#include "formats/texture_file.h"

#include <fmt/format.h>

#include "base/text.h"
#include "formats/include.h"
#include "image/texture_image.h"

namespace glint {
namespace {

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
    const auto text = open_text(reading, from, at, name);
    if (!text) return nullptr;
    return image_of_text(reading, *text, path, [&](const std::string& why) {
        reading.diagnostics.error(from.place, at.offset, at.length, fmt::format("{}: {}", quoted(name), why));
    });
}

std::shared_ptr<const TextureImage> optional_texture_image(LoadState& reading, const ReadText& from,
                                                           const Token& at, const std::string& name,
                                                           std::string& path, std::string_view without) {
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
