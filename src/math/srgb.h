// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace glint {

/// The sRGB curve (IEC 61966-2-1) of a linear channel, from 0 to 1. Smaller numbers and NaN give 0, larger
/// ones 1.
double srgb_encode(double linear);
/// Its inverse, for any number.
double srgb_decode(double encoded);

}  // namespace glint
