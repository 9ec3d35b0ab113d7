// SPDX-License-Identifier: Apache-2.0
#include "image/palette_numbers.h"

#include "image/png_checksum.h"

namespace glint {

std::string png_of_palette_numbers(std::string_view file) {
    constexpr std::size_t k_signature = 8, k_color_type = 25, k_around_data = 12;
    if (!file.starts_with("\x89PNG\r\n\x1a\n") || file.size() <= k_color_type || file[k_color_type] != 3)
        return {};
    const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<std::uint8_t>(file[i])}; };
    for (std::size_t at = k_signature; file.size() - at >= k_around_data;) {
        const std::size_t size = byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
        if (size > file.size() - at - k_around_data) return {};
        const std::size_t name = at + 4, data = at + 8, end = data + size;
        if (file.substr(name, 4) == "PLTE") {
            std::string made(file);
            for (std::size_t i = 0; i < size; ++i)
                made[data + i] = i % 3 == 0 ? static_cast<char>(i / 3) : '\0';
            const std::uint32_t checksum =
                png_checksum({reinterpret_cast<const std::uint8_t*>(made.data()) + name, size + 4});
            for (std::size_t i = 0; i < 4; ++i) made[end + i] = static_cast<char>(checksum >> (24 - 8 * i));
            return made;
        }
        at = end + 4;
    }
    return {};
}

}  // namespace glint
