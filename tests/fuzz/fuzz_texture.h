// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fuzzing of textures' files: read them and check the result.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/texture_image.h"

namespace glint::test {

/// Makes the checksums of a PNG's chunks right: a change that they show is found before the data is decoded.
inline void repair_checksums(std::vector<std::uint8_t>& png) {
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t length = std::size_t{png[at]} << 24 | std::size_t{png[at + 1]} << 16 |
                                   std::size_t{png[at + 2]} << 8 | png[at + 3];
        if (length > png.size() - at - 12) return;
        std::uint32_t crc = 0xffffffffu;
        for (std::size_t i = at + 4; i < at + 8 + length; ++i) {
            crc ^= png[i];
            for (int k = 0; k < 8; ++k) crc = (crc & 1) != 0 ? 0xedb88320u ^ crc >> 1 : crc >> 1;
        }
        at += 8 + length;
        for (int shift = 24; shift >= 0; shift -= 8) png[at++] = static_cast<std::uint8_t>(~crc >> shift);
    }
}

/// Decodes the bytes twice, with low limits. Returns an error message about the results, or an empty string.
inline std::string fuzz_texture(std::span<const std::uint8_t> bytes) {
    DecodeOptions options;
    options.max_pixels = 1 << 16;
    options.max_memory = 1 << 22;
    std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
    if (file.size() > 8 && file[0] == 0x89) repair_checksums(file);
    const Result<TextureImage> result = decode_texture(file, options), again = decode_texture(file, options);
    if (result.has_value() != result.message.empty())
        return "a picture and an error, or neither: " + result.message;
    if (result.message != again.message) return "another error: " + result.message + "; " + again.message;
    if (!result) return {};
    if (!(*result == *again)) return "other words";
    if (std::int64_t{result->width} * result->height > options.max_pixels)
        return "a picture that is too large";
    const std::size_t words = std::visit([](const auto& w) { return w.size(); }, result->words);
    return words == std::size_t{result->width} * result->height * result->channels() ? std::string()
                                                                                     : "too few words";
}

}  // namespace glint::test
