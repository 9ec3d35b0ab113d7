#pragma once
// From linear numbers to the whole numbers of a file.
#include <bit>
#include <cstddef>
#include <cstdint>

#include "glint/image.h"

namespace glint {

/// Clamps to [0, 1] (NaN is 0), multiplies by `scale` (255 or 65535) and rounds half to even. The product of
/// a float and a scale is exact in double, and adding 2^52 rounds it to a whole number, as IEEE 754 says; it
/// needs the rounding mode to be nearest (base/fp_environment.h).
inline std::uint32_t quantize(double value, double scale) {
    const double clamped = value > 0 ? (value < 1 ? value : 1) : 0;
    constexpr double two_to_52 = 4503599627370496.0;
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(clamped * scale + two_to_52));
}

/// The sRGB transfer curve (IEC 61966-2-1) of a linear value; 0 and 1 stay, NaN and below are 0, above are 1.
double srgb_encode(double linear);

/// The samples of `count` channel values as a file stores them: `bits` / 8 bytes each, big-endian. Nearest
/// rounding, too.
void quantize_row(const float* values, std::size_t count, int bits, Transfer transfer, std::uint8_t* out);

}  // namespace glint
