// SPDX-License-Identifier: Apache-2.0
#include "cli/whole_picture.h"

#include <algorithm>
#include <utility>

namespace glint::cli {
namespace {

std::vector<float> padded(const std::vector<float>& values, std::size_t channels, float around,
                          const Crop& whole, const Crop& part) {
    const auto size = [](std::int32_t n) { return static_cast<std::size_t>(n); };
    std::vector<float> all(channels * size(whole.width) * size(whole.height), around);
    const std::size_t row = channels * size(part.width);
    for (std::size_t y = 0; y < size(part.height); ++y) {
        const std::size_t to = channels * ((size(part.y) + y) * size(whole.width) + size(part.x));
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                    all.begin() + static_cast<std::ptrdiff_t>(to));
    }
    return all;
}

}  // namespace

void put_in_whole(Rendering& rendering, const Crop& whole, const Crop& part) {
    rendering.image = {whole.width, whole.height, padded(rendering.image.rgb, 3, 0, whole, part)};
    for (LayerImage& layer : rendering.layers) {
        const float around = layer.layer == Layer::alpha ? 1.0f : 0.0f;
        layer.values = padded(layer.values, static_cast<std::size_t>(layer.channels), around, whole, part);
        layer.width = whole.width;
        layer.height = whole.height;
    }
}

}  // namespace glint::cli
