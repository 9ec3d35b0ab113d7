// SPDX-License-Identifier: Apache-2.0
#pragma once
// The words of a texture in one line: "23 x 17, 3 of 8 bits, 0123456789abcdef". tests/image/textures/words
// has it for each file of its folder; the tests of native builds and of the browser build compare with it.
#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "glint/texture.h"

namespace glint::test {

inline std::string words_of(const TextureImage& image) {
    // FNV-1a of the words' bytes, the lower byte first.
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&hash](std::uint32_t byte) { hash = (hash ^ byte) * 0x100000001b3u; };
    int bits = 8;
    if (const auto* wide = std::get_if<std::vector<std::uint16_t>>(&image.words)) {
        bits = 16;
        for (const std::uint16_t word : *wide) {
            add(word & 255u);
            add(std::uint32_t{word} >> 8);
        }
    } else {
        for (const std::uint8_t word : std::get<std::vector<std::uint8_t>>(image.words)) add(word);
    }
    return fmt::format("{} x {}, {} of {} bits, {:016x}", image.width, image.height, image.channels(), bits,
                       hash);
}

}  // namespace glint::test
