// SPDX-License-Identifier: Apache-2.0
#include "image/quantize.h"

#include "base/fp_environment.h"
#include "math/elementary.h"
#include "math/srgb.h"

namespace glint {

std::uint32_t to_number(float value, int bits, const ByteRule& rule) {
    const DefaultFpEnvironment environment;
    std::uint8_t bytes[2] = {};
    quantize_row(&value, 1, bits, rule, bytes);
    return bits == 8 ? bytes[0] : bytes[0] * 256u + bytes[1];
}

std::uint32_t to_number(float value, int bits, Transfer transfer) {
    return to_number(value, bits, ByteRule{transfer});
}

std::uint8_t to_byte(float value, const ByteRule& rule) {
    return static_cast<std::uint8_t>(to_number(value, 8, rule));
}

std::uint8_t to_byte(float value, Transfer transfer) { return to_byte(value, ByteRule{transfer}); }

void quantize_row(const float* values, std::size_t count, int bits, const ByteRule& rule, std::uint8_t* out) {
    const auto each = [=](auto whole) {
        for (std::size_t i = 0; i < count; ++i) {
            const double value = static_cast<double>(values[i]);
            if (bits == 8) {
                out[i] = static_cast<std::uint8_t>(whole(value, 255));
            } else {
                const std::uint32_t word = whole(value, 65535);
                out[2 * i] = static_cast<std::uint8_t>(word >> 8);
                out[2 * i + 1] = static_cast<std::uint8_t>(word);
            }
        }
    };
    if (rule == ByteRule{}) return each([](double value, double scale) { return quantize(value, scale); });
    each([&](double value, double scale) {
        if (rule.gamma != 1) value = value > 0 && value < 1 ? pow(value, rule.gamma) : value;
        if (rule.transfer == Transfer::srgb) value = srgb_encode(value);
        return quantize(value, scale, rule.rounding);
    });
}

Image as_written(Image image, const ByteRule& rule) {
    if (rule == ByteRule{}) return image;
    const DefaultFpEnvironment environment;
    std::vector<std::uint8_t> bytes(image.rgb.size());
    quantize_row(image.rgb.data(), bytes.size(), 8, rule, bytes.data());
    for (std::size_t i = 0; i < bytes.size(); ++i) image.rgb[i] = static_cast<float>(bytes[i]) / 255;
    return image;
}

}  // namespace glint
