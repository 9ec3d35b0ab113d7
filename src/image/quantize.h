// SPDX-License-Identifier: Apache-2.0
#pragma once
// Converts linear numbers to the whole numbers of a file.
#include <cstddef>
#include <cstdint>

#include "glint/image.h"
#include "math/quantize.h"

namespace glint {

/// Converts `count` channel values to samples of a file: `bits` / 8 bytes each, big-endian, by
/// the rule.
void quantize_row(const float* values, std::size_t count, int bits, const ByteRule& rule, std::uint8_t* out);

/// The picture as a file with 8 bits gives it back: n / 255 for each byte n. Unchanged by the default rule,
/// which decides about bytes where they are needed.
Image as_written(Image image, const ByteRule& rule);

}  // namespace glint
