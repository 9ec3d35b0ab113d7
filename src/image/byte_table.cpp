// SPDX-License-Identifier: Apache-2.0
#include "image/byte_table.h"

#include "math/elementary.h"
#include "math/number.h"
#include "math/quantize.h"
#include "math/srgb.h"

namespace glint {
namespace {

// Near the least number of a byte: the inverse of the rule.
float near_least(unsigned byte, const ByteRule& rule) {
    const double whole = static_cast<double>(byte) - (rule.rounding == Rounding::down ? 0 : 0.5);
    double value = whole / 255;
    if (rule.transfer == Transfer::srgb) value = srgb_decode(value);
    return static_cast<float>(rule.gamma == 1 ? value : pow(value, 1 / rule.gamma));
}

float neighbour(float value, int step) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + static_cast<std::uint32_t>(step));
}

}  // namespace

double transferred(double value, const ByteRule& rule) {
    if (rule.gamma != 1 && value > 0 && value < 1) value = pow(value, rule.gamma);
    return rule.transfer == Transfer::srgb ? srgb_encode(value) : value;
}

std::uint8_t byte_of(float value, const ByteRule& rule) {
    const double v = transferred(static_cast<double>(value), rule);
    return static_cast<std::uint8_t>(quantize(v, 255, rule.rounding));
}

ByteTable::ByteTable(const ByteRule& rule) : rule_(rule) {
    least_[0] = 0;
    for (unsigned byte = 1; byte < 256; ++byte) {
        float least = near_least(byte, rule);
        while (least > 0 && byte_of(least, rule) >= byte) least = neighbour(least, -1);
        while (byte_of(least, rule) < byte) least = neighbour(least, 1);
        least_[byte] = least;
    }
    least_[256] = static_cast<float>(number::k_infinity);
    unsigned byte = 0;
    for (std::uint32_t i = 0; i < first_.size(); ++i) {
        byte = search(byte, std::bit_cast<float>(k_begin_bits + (i << k_shift)));
        first_[i] = static_cast<std::uint8_t>(byte);
    }
}

}  // namespace glint
