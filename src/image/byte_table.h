// SPDX-License-Identifier: Apache-2.0
#pragma once
// The bytes of many numbers by one rule, without a power for each.
#include <array>
#include <bit>
#include <cstdint>

#include "glint/bytes.h"

namespace glint {

/// A number from 0 to 1 after gamma and the transfer function. Others are as far beyond, or at the end.
double transferred(double value, const ByteRule& rule);

/// The byte of one number by a rule.
std::uint8_t byte_of(float value, const ByteRule& rule);

/// The bytes of all numbers, found among the least numbers of each byte. They are those of byte_of(): it
/// grows with the number, because neighbouring floats are much farther apart than the errors of its powers,
/// if gamma is from 0.001 to 1000.
class ByteTable {
  public:
    static bool has(const ByteRule& rule) { return rule.gamma >= 1e-3 && rule.gamma <= 1e3; }
    ByteTable() : ByteTable(ByteRule{}) {}
    explicit ByteTable(const ByteRule& rule);

    const ByteRule& rule() const { return rule_; }
    std::uint8_t operator()(float value) const {
        if (!(value >= k_begin)) return value >= least_[1] ? search(0, value) : std::uint8_t{0};
        if (value >= 1) return 255;
        return search(first_[(std::bit_cast<std::uint32_t>(value) - k_begin_bits) >> k_shift], value);
    }

  private:
    static constexpr float k_begin = 0x1p-16f;  // numbers below it are searched from 0
    static constexpr std::uint32_t k_begin_bits = std::bit_cast<std::uint32_t>(k_begin);
    static constexpr int k_shift = 15;  // 256 intervals from a power of 2 to the next

    std::uint8_t search(unsigned byte, float value) const {
        while (value >= least_[byte + 1]) ++byte;
        return static_cast<std::uint8_t>(byte);
    }

    ByteRule rule_;
    std::array<float, 257> least_;              // the least number of each byte; infinite after the last
    std::array<std::uint8_t, 16 * 256> first_;  // the byte of each interval's least number
};

}  // namespace glint
