// SPDX-License-Identifier: Apache-2.0
#pragma once
// Materials of transparent surfaces.
#include "glint/scene.h"

namespace glint::test {

/// Without diffuse light.
inline Material sheet(Color color, double filter, double transmit) {
    Material m;
    m.color = color;
    m.ambient = color * 0.5;
    m.diffuse = {0, 0, 0};
    m.filter = filter;
    m.transmit = transmit;
    return m;
}

}  // namespace glint::test
