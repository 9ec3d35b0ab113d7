#pragma once
// From linear numbers to the whole numbers of a file.
#include <cstddef>
#include <cstdint>

#include "glint/image.h"

namespace glint {

/// Clamps to [0, 1] (NaN is 0), multiplies by `scale` (255 or 65535) and rounds half to even. The product of
/// a float and a scale is exact in double and so is the comparison with one half: the result depends on no
/// rounding mode.
inline std::uint32_t quantize(double value, double scale) {
    const double clamped = value > 0 ? (value < 1 ? value : 1) : 0;
    const double scaled = clamped * scale;
    const auto whole = static_cast<std::int32_t>(scaled);
    const double rest = scaled - whole;
    const int above_half = rest > 0.5, at_half = rest == 0.5;  // without branches: values are anywhere
    return static_cast<std::uint32_t>(whole + (above_half | (at_half & whole)));
}

/// The sRGB transfer curve (IEC 61966-2-1) of a linear value; 0 and 1 stay, NaN and below are 0, above are 1.
double srgb_encode(double linear);

/// The samples of `count` channel values as a file stores them: `bits` / 8 bytes each, big-endian.
void quantize_row(const float* values, std::size_t count, int bits, Transfer transfer, std::uint8_t* out);

}  // namespace glint
