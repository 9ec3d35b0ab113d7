// SPDX-License-Identifier: Apache-2.0
#pragma once
// From linear numbers to the whole numbers of a file.
#include <cstddef>
#include <cstdint>

#include "glint/image.h"
#include "math/quantize.h"

namespace glint {

/// The sRGB transfer curve (IEC 61966-2-1) of a linear value; 0 and 1 stay, NaN and below are 0, above are 1.
double srgb_encode(double linear);

/// The samples of `count` channel values as a file stores them: `bits` / 8 bytes each, big-endian. Nearest
/// rounding, too.
void quantize_row(const float* values, std::size_t count, int bits, Transfer transfer, std::uint8_t* out);

}  // namespace glint
