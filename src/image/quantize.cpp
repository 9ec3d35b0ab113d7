// SPDX-License-Identifier: Apache-2.0
#include "image/quantize.h"

#include "base/fp_environment.h"
#include "image/byte_table.h"

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

namespace {

void quantize_bytes(const float* values, std::size_t count, const ByteRule& rule, std::uint8_t* out) {
    // A table takes the time of about as many numbers; of pictures, the next row has the same rule.
    constexpr std::size_t k_many = 1024;
    thread_local ByteTable table;
    if (count >= k_many && ByteTable::has(rule) && !(table.rule() == rule)) table = ByteTable(rule);
    const bool is_known = table.rule() == rule;
    for (std::size_t i = 0; i < count; ++i) out[i] = is_known ? table(values[i]) : byte_of(values[i], rule);
}

}  // namespace

void quantize_row(const float* values, std::size_t count, int bits, const ByteRule& rule, std::uint8_t* out) {
    if (bits == 8 && !(rule == ByteRule{})) return quantize_bytes(values, count, rule, out);
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
    each(
        [&](double value, double scale) { return quantize(transferred(value, rule), scale, rule.rounding); });
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
