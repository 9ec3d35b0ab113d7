// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether two Worlds give the same bits.
#include <gtest/gtest.h>

#include <cstring>

#include "glint/render.h"
#include "world/world.h"

namespace glint::test {

inline bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/// Compares every layer, and the number of rays of each kind.
inline ::testing::AssertionResult draw_the_same(const World& a, const World& b, int threads = 1) {
    RenderOptions options;
    options.threads = threads;
    for (const LayerInfo& info : layer_infos()) options.layers.push_back(info.layer);
    const Result<Rendering> of_a = render(a, options), of_b = render(b, options);
    if (!of_a || !of_b) return ::testing::AssertionFailure() << of_a.message << of_b.message;
    if (of_a->image.width != of_b->image.width || !same_bits(of_a->image.rgb, of_b->image.rgb))
        return ::testing::AssertionFailure() << "the pictures differ";
    for (std::size_t l = 0; l < options.layers.size(); ++l) {
        if (!same_bits(of_a->layers[l].values, of_b->layers[l].values))
            return ::testing::AssertionFailure() << "layer " << layer_infos()[l].name << " differs";
    }
    if (of_a->rays.total() != of_b->rays.total() || of_a->rays.shadow != of_b->rays.shadow)
        return ::testing::AssertionFailure() << "the rays differ in number";
    return ::testing::AssertionSuccess();
}

}  // namespace glint::test
