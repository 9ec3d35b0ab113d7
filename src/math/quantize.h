// SPDX-License-Identifier: Apache-2.0
#pragma once
// From a linear number to the whole number of a file.
#include <bit>
#include <cstdint>

namespace glint {

/// Clamps to [0, 1] (NaN is 0), multiplies by `scale` (255 or 65535) and rounds half to even. The product of
/// a float and a scale is exact in double, and adding 2^52 rounds it to a whole number, as IEEE 754 says; it
/// needs the rounding mode to be nearest (base/fp_environment.h).
inline std::uint32_t quantize(double value, double scale) {
    const double clamped = value > 0 ? (value < 1 ? value : 1) : 0;
    constexpr double two_to_52 = 4503599627370496.0;
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(clamped * scale + two_to_52));
}

}  // namespace glint
