// SPDX-License-Identifier: Apache-2.0
#pragma once
// CRC-32 of ISO 3309, as PNG's annex D computes it. zlib, which has it too, is not in every build.
#include <array>
#include <cstdint>
#include <span>

namespace glint {

inline std::uint32_t png_checksum(std::span<const std::uint8_t> bytes) {
    static constexpr auto table = [] {
        std::array<std::uint32_t, 256> values{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            std::uint32_t c = i;
            for (int k = 0; k < 8; ++k) c = (c & 1) != 0 ? 0xedb88320u ^ c >> 1 : c >> 1;
            values[i] = c;
        }
        return values;
    }();
    std::uint32_t crc = 0xffffffffu;
    for (const std::uint8_t byte : bytes) crc = table[(crc ^ byte) & 255] ^ crc >> 8;
    return ~crc;
}

}  // namespace glint
