// SPDX-License-Identifier: Apache-2.0
#pragma once
// Colors by a number: Texture::color_map and BackgroundGradient::color_map.
#include <algorithm>
#include <cstddef>
#include <span>

#include "glint/texture.h"

namespace glint {

/// The color at a number: between two colors of the map, or one of them twice.
struct MapColor {
    std::size_t first = 0, second = 0;
    double weight = 0;  // of the second
    Color color;
    double alpha = 1;
};

/// The mean of two numbers is exact where they are equal.
inline double mixed(double a, double b, double second) { return a + (b - a) * second; }

/// colors: at least one, in the order of `at`.
inline MapColor map_color(std::span<const TextureColor> colors, double u, TextureFilter filter) {
    const auto next = std::upper_bound(colors.begin(), colors.end(), u,
                                       [](double at, const TextureColor& color) { return at < color.at; });
    const auto last = next == colors.begin() ? next : next - 1;
    const auto index = static_cast<std::size_t>(last - colors.begin());
    MapColor found{index, index, 0, last->color, last->alpha};
    if (filter == TextureFilter::nearest || next == colors.end() || next == last) return found;
    found.second = index + 1;
    found.weight = (u - last->at) / (next->at - last->at);
    const auto between = [&](double a, double b) { return mixed(a, b, found.weight); };
    found.color = {between(last->color.r, next->color.r), between(last->color.g, next->color.g),
                   between(last->color.b, next->color.b)};
    found.alpha = between(last->alpha, next->alpha);
    return found;
}

}  // namespace glint
