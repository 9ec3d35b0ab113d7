// SPDX-License-Identifier: Apache-2.0
#pragma once
// The layers of a pixel, added up from an explanation.
#include <gtest/gtest.h>

#include <cmath>

#include "glint/explain.h"

namespace glint::test {

/// The value of a layer whose samples have this sum.
inline float film(double sum, int samples) {
    const double n = static_cast<double>(samples) * samples;
    const double mean = samples > 1 ? sum / n : sum;
    return static_cast<float>(std::fmin(std::fmax(std::isnan(mean) ? 0 : mean, -1e30), 1e30));
}

/// The pixel's layers, computed from the contributions of the rays, in their order.
inline void add_up(const Explanation& e, float (&layers)[k_light_layers][3]) {
    double sums[k_light_layers][3] = {};
    const auto add = [&](Layer layer, Color c) {
        double(&sum)[3] = sums[static_cast<std::size_t>(layer)];
        sum[0] += c.r;
        sum[1] += c.g;
        sum[2] += c.b;
    };
    for (std::size_t i = 0; i < e.rays.size(); ++i) {
        const ExplainedRay& ray = e.rays[i];
        const auto layer = layer_of(e, i);
        if (!ray.hit) {
            add(layer.value_or(Layer::background), ray.background);
            add(layer.value_or(Layer::fog), ray.fog);
            continue;
        }
        constexpr Layer own[] = {Layer::ambient, Layer::diffuse, Layer::specular, Layer::emission};
        for (int part = 0; part < 4; ++part) add(layer.value_or(own[part]), ray.hit->parts[part]);
        if (ray.hit->occlusion) add(layer.value_or(Layer::sky), ray.hit->occlusion->part);
        add(layer.value_or(Layer::fog), ray.fog);
    }
    for (int l = 0; l < k_light_layers; ++l)
        for (int c = 0; c < 3; ++c) layers[l][c] = film(sums[l][c], e.samples);
}

/// The layers of the pixel are the sums of its rays, and add up to its value.
inline void expect_added_up(const Explanation& e, int x, int y) {
    float layers[k_light_layers][3];
    add_up(e, layers);
    for (int c = 0; c < 3; ++c) {
        float value = 0;
        for (int l = 0; l < k_light_layers; ++l) {
            ASSERT_EQ(layers[l][c], e.layers[l][c]) << x << ',' << y << ' ' << l;
            value += e.layers[l][c];
        }
        ASSERT_EQ(value, e.value[c]);
    }
}

}  // namespace glint::test
