// SPDX-License-Identifier: Apache-2.0
#include "cli/half_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace glint::cli {
namespace {

using Pixel = std::array<std::uint8_t, 3>;

// The mean of the pixels in a rectangle; each is clamped as in a file.
Pixel mean(const Image& image, int x0, int x1, int y0, int y1, const ByteRule& rule) {
    std::array<double, 3> sum{};
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += std::clamp(image.rgb[3 * (std::size_t(y) * image.width + x) + c], 0.0f, 1.0f);
            }
        }
    }
    const double count = double(x1 - x0) * (y1 - y0);
    Pixel pixel;
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = to_byte(static_cast<float>(sum[c] / count), rule);
    return pixel;
}

// The first of `count` pixels that belongs to part i of `parts`.
int begin_of(int i, int parts, int count) { return static_cast<int>(std::int64_t{i} * count / parts); }

}  // namespace

std::string half_blocks(const Image& image, int columns, const ByteRule& rule) {
    const int width = std::clamp(columns, 1, image.width);
    const int height =
        std::max(1, static_cast<int>((std::int64_t{image.height} * width + image.width / 2) / image.width));
    const auto pixel = [&](int x, int y) {
        return mean(image, begin_of(x, width, image.width), begin_of(x + 1, width, image.width),
                    begin_of(y, height, image.height), begin_of(y + 1, height, image.height), rule);
    };
    std::string text;
    auto out = std::back_inserter(text);
    for (int y = 0; y < height; y += 2) {
        for (int x = 0; x < width; ++x) {
            const Pixel upper = pixel(x, y);
            fmt::format_to(out, "\x1b[38;2;{};{};{}", upper[0], upper[1], upper[2]);
            if (y + 1 < height) {
                const Pixel lower = pixel(x, y + 1);
                fmt::format_to(out, ";48;2;{};{};{}", lower[0], lower[1], lower[2]);
            }
            text += "m▀";
        }
        text += "\x1b[0m\n";
    }
    return text;
}

}  // namespace glint::cli
