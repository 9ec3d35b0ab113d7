// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures for tests of the encoders.
#include <cstdint>

#include "glint/image.h"

namespace glint::test {

/// Smooth parts, flat parts and noise; values also below 0 and above 1.
inline Image make_picture(std::int32_t width, std::int32_t height) {
    Image image{width, height, {}};
    std::uint32_t state = 12345;
    for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                state = state * 1664525u + 1013904223u;
                const float noise = static_cast<float>(state >> 8) / 16777216.0f;
                const float smooth =
                    static_cast<float>(x + 2 * y + 30 * c) / static_cast<float>(width + 2 * height);
                image.rgb.push_back(x < width / 3    ? 0.25f * static_cast<float>(c)
                                    : y < height / 2 ? smooth
                                                     : 1.4f * noise - 0.2f);
            }
        }
    }
    return image;
}

}  // namespace glint::test
