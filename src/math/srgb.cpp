// SPDX-License-Identifier: Apache-2.0
#include "math/srgb.h"

#include "math/elementary.h"

namespace glint {

double srgb_encode(double linear) {
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    if (linear <= 0.0031308) return 12.92 * linear;
    return 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace glint
