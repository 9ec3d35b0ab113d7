// SPDX-License-Identifier: Apache-2.0
#include "image/quantize.h"

#include "base/fp_environment.h"
#include "math/elementary.h"

namespace glint {

double srgb_encode(double linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    if (linear <= 0.0031308) return 12.92 * linear;
    return 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

std::uint32_t to_number(float value, int bits, Transfer transfer) {
    const DefaultFpEnvironment environment;
    std::uint8_t bytes[2] = {};
    quantize_row(&value, 1, bits, transfer, bytes);
    return bits == 8 ? bytes[0] : bytes[0] * 256u + bytes[1];
}

std::uint8_t to_byte(float value, Transfer transfer) {
    return static_cast<std::uint8_t>(to_number(value, 8, transfer));
}

void quantize_row(const float* values, std::size_t count, int bits, Transfer transfer, std::uint8_t* out) {
    const auto each = [=](auto curve) {
        if (bits == 8) {
            for (std::size_t i = 0; i < count; ++i) {
                out[i] = static_cast<std::uint8_t>(quantize(curve(static_cast<double>(values[i])), 255));
            }
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t word = quantize(curve(static_cast<double>(values[i])), 65535);
            out[2 * i] = static_cast<std::uint8_t>(word >> 8);
            out[2 * i + 1] = static_cast<std::uint8_t>(word);
        }
    };
    if (transfer == Transfer::srgb) {
        each(srgb_encode);
    } else {
        each([](double value) { return value; });
    }
}

}  // namespace glint
