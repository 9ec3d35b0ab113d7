// SPDX-License-Identifier: Apache-2.0
#include "image/byte_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "image/quantize.h"

namespace glint {
namespace {

std::vector<ByteRule> rules() {
    std::vector<ByteRule> all;
    for (const Transfer transfer : {Transfer::none, Transfer::srgb}) {
        for (const double gamma : {1.0, 2.2, 1 / 2.2, 0.5, 1.8, 0.001, 0.05, 30.0, 1000.0}) {
            for (const Rounding rounding : {Rounding::half_even, Rounding::half_up, Rounding::down})
                all.push_back({transfer, gamma, rounding});
        }
    }
    return all;
}

TEST(ByteTable, GivesTheBytesOfSingleNumbers) {
    std::mt19937 random(5);
    for (const ByteRule& rule : rules()) {
        const ByteTable table(rule);
        const auto expect_same = [&](float value) {
            ASSERT_EQ(table(value), byte_of(value, rule))
                << value << " gamma " << rule.gamma << " srgb " << (rule.transfer == Transfer::srgb);
        };
        for (int i = 0; i < 10000; ++i) {
            const float value = static_cast<float>(random()) / 4294967296.0f;
            expect_same(value);
            expect_same(value * value * value * value);
        }
        // Beside the border of each byte, and of each interval of the table.
        for (int byte = 1; byte < 256; ++byte) {
            float low = 0, high = 1;
            while (std::nextafter(low, 1.0f) < high) {
                const float middle = low + (high - low) / 2;
                (byte_of(middle, rule) >= byte ? high : low) = middle;
            }
            float value = high;
            for (int i = 0; i < 20; ++i) value = std::nextafter(value, 0.0f);
            for (int i = 0; i < 40; ++i, value = std::nextafter(value, 2.0f)) expect_same(value);
        }
        for (float value = 0x1p-18f; value < 2; value *= 1 + 0x1p-10f) {
            for (const float end : {0.0f, 2.0f}) expect_same(std::nextafter(value, end));
        }
        constexpr float k_infinity = std::numeric_limits<float>::infinity();
        for (const float value : {0.0f, -0.0f, -1.0f, 1.0f, 2.0f, 1e-45f, 1e-38f, k_infinity, -k_infinity,
                                  std::numeric_limits<float>::quiet_NaN(), 0.0031308f, 0.99999994f})
            expect_same(value);
    }
}

TEST(ByteTable, RowsHaveTheBytesOfSingleNumbers) {
    std::vector<float> values(3000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i) / 2900;
    std::vector<std::uint8_t> bytes(values.size());
    for (const ByteRule& rule : rules()) {
        for (const std::size_t count : {std::size_t{7}, values.size(), std::size_t{7}}) {
            quantize_row(values.data(), count, 8, rule, bytes.data());
            for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(bytes[i], byte_of(values[i], rule)) << i;
        }
    }
}

}  // namespace
}  // namespace glint
