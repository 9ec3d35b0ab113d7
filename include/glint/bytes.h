// SPDX-License-Identifier: Apache-2.0
#pragma once
// How the numbers of a picture become the whole numbers of a file.
#include <cstdint>

namespace glint {

/// none: the numbers as they are. srgb: the sRGB curve, for use with photographs.
enum class Transfer : std::uint8_t { none, srgb };

/// How numbers from 0 to 255 (65535) become whole. half_even: the nearest; halves to the even one. half_up:
/// the nearest; halves up (POV-Ray). down: what is behind the point is cut off (Tachyon).
enum class Rounding : std::uint8_t { half_even, half_up, down };

/// The whole number for a channel c: round(255 v) with v = transfer(c^gamma), c from 0 to 1.
struct ByteRule {
    Transfer transfer = Transfer::none;
    double gamma = 1;  ///< > 0; POV-Ray's assumed_gamma
    Rounding rounding = Rounding::half_even;
    friend bool operator==(const ByteRule&, const ByteRule&) = default;
};

}  // namespace glint
