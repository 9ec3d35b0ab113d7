// SPDX-License-Identifier: Apache-2.0
#pragma once
// Converts a linear number to a whole number for a file.
#include <bit>
#include <cstdint>

#include "glint/bytes.h"

namespace glint {

/// Clamps to [0, 1] (NaN gives 0), multiplies by `scale` (255 or 65535) and rounds half to even. The product
/// of a float and the scale is exact in double, and adding 2^52 rounds it to a whole number by IEEE 754. The
/// rounding mode must be to nearest (base/fp_environment.h).
inline std::uint32_t quantize(double value, double scale) {
    const double clamped = value > 0 ? (value < 1 ? value : 1) : 0;
    constexpr double two_to_52 = 4503599627370496.0;
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(clamped * scale + two_to_52));
}

/// The same with another rounding.
inline std::uint32_t quantize(double value, double scale, Rounding rounding) {
    if (rounding == Rounding::half_even) return quantize(value, scale);
    const double clamped = value > 0 ? (value < 1 ? value : 1) : 0;
    return static_cast<std::uint32_t>(clamped * scale + (rounding == Rounding::half_up ? 0.5 : 0));
}

}  // namespace glint
