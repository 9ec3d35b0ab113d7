// SPDX-License-Identifier: Apache-2.0
// What was measured of POV-Ray: pictures with 8 bits a channel have 256 red + green, and those with a palette
// 256 times the color's number, which is red here (image/palette_numbers.h); of grey with 16 bits the
// word counts. Of grey PNG files with 8 bits and of colors with 16 bits it is POV-Ray's grey of the three
// channels, in single precision and cut off to a whole number.
#include "formats/povray/height_words.h"

#include <algorithm>
#include <optional>

namespace glint::povray {
namespace {

enum class HeightRule : std::uint8_t { two_bytes, word, grey };

// The greatest number of a PPM or PGM file: the fourth word of its header.
std::uint32_t greatest_of_netpbm(std::string_view file) {
    std::size_t at = 2;
    std::uint32_t number = 0;
    for (int field = 0; field < 3; ++field) {
        while (at < file.size() && (file[at] < '0' || file[at] > '9')) {
            if (file[at] == '#') at = std::min(file.find('\n', at), file.size());
            if (at < file.size()) ++at;
        }
        for (number = 0; at < file.size() && file[at] >= '0' && file[at] <= '9' && number < 100000; ++at)
            number = number * 10 + static_cast<std::uint32_t>(file[at] - '0');
    }
    return number;
}

std::optional<HeightRule> rule_of(std::string_view file, bool is_16_bit) {
    const auto byte = [&](std::size_t i) { return i < file.size() ? static_cast<std::uint8_t>(file[i]) : 0; };
    const HeightRule of_color = is_16_bit ? HeightRule::grey : HeightRule::two_bytes;
    const HeightRule of_grey = is_16_bit ? HeightRule::word : HeightRule::two_bytes;
    if (file.starts_with("\x89PNG")) {
        constexpr std::size_t k_color_type = 25;
        switch (byte(k_color_type)) {
            case 0:
                return is_16_bit ? HeightRule::word : HeightRule::grey;
            case 3:
                return HeightRule::two_bytes;
            case 4:
                return of_grey;
            default:
                return of_color;
        }
    }
    if (byte(0) == 0xff && byte(1) == 0xd8) return of_color;  // JPEG
    if (byte(0) == 'P' && byte(1) >= '2' && byte(1) <= '6') {
        const std::uint32_t greatest = greatest_of_netpbm(file);
        if (greatest != 255 && greatest != 65535) return std::nullopt;
        return byte(1) == '2' || byte(1) == '5' ? of_grey : of_color;
    }
    const int kind = byte(2) & 7, bits = byte(16);  // TGA: 2 has colors, 3 is grey
    return kind == 3 || (kind == 2 && bits >= 24) ? std::optional(HeightRule::two_bytes) : std::nullopt;
}

template <class Word> std::uint16_t height_of(const Word* texel, HeightRule rule) {
    constexpr float most = sizeof(Word) == 1 ? 255 : 65535;
    switch (rule) {
        case HeightRule::two_bytes:
            return static_cast<std::uint16_t>(texel[0] * 256 + texel[1]);
        case HeightRule::word:
            return texel[0];
        default: {
            const float r = texel[0] / most, g = texel[1] / most, b = texel[2] / most;
            const float grey = 0.297f * r + 0.589f * g + 0.114f * b;
            const auto cut = static_cast<std::uint16_t>(static_cast<double>(grey) * most);
            return static_cast<std::uint16_t>(sizeof(Word) == 1 ? cut * 257 : cut);
        }
    }
}

}  // namespace

bool read_heights(const TextureImage& image, std::string_view file, CountedVector<std::uint16_t>& heights) {
    const auto rule = rule_of(file, image.words.index() == 1);
    if (!rule) return false;
    heights.resize(std::size_t{image.width} * image.height);
    std::visit(
        [&](const auto& words) {
            for (std::uint32_t z = 0; z < image.height; ++z) {
                const std::size_t row = std::size_t{image.height - 1 - z} * image.width;
                for (std::uint32_t x = 0; x < image.width; ++x)
                    heights[std::size_t{z} * image.width + x] =
                        height_of(words.data() + (row + x) * image.channels(), *rule);
            }
        },
        image.words);
    return true;
}

}  // namespace glint::povray
