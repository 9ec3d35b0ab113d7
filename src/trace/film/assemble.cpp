// SPDX-License-Identifier: Apache-2.0
#include "trace/film/assemble.h"

#include <algorithm>

#include "base/huge_pages.h"

namespace glint {
namespace {

// The rows of a tile with `channels` floats a pixel.
void copy_rows(const float* from, std::size_t row_floats, std::size_t channels, const Crop& area,
               const Crop& picture, std::vector<float>& values) {
    const auto width = static_cast<std::size_t>(picture.width);
    std::size_t first =
        static_cast<std::size_t>(area.y - picture.y) * width + static_cast<std::size_t>(area.x - picture.x);
    for (std::int32_t y = 0; y < area.height; ++y, first += width, from += row_floats)
        std::copy_n(from, channels * static_cast<std::size_t>(area.width), values.data() + channels * first);
}

}  // namespace

std::size_t count_numbers(const Crop& picture) {
    return 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

std::vector<float> claim_floats(std::size_t count, int threads, CancelFlag cancel) {
    constexpr std::size_t step = std::size_t{1} << 22;  // floats between two looks at `cancel`
    std::vector<float> values;
    values.reserve(count);
    advise_huge_pages(values.data(), count * sizeof(float));
    prefault_pages(values.data(), count * sizeof(float), threads, cancel);
    while (values.size() < count && !cancel.is_set()) values.resize(std::min(count, values.size() + step));
    return values;
}

std::vector<LayerImage> empty_layers(const std::vector<Layer>& wanted, const Crop& picture) {
    std::vector<LayerImage> layers;
    for (const Layer layer : wanted) {
        const std::size_t channels = layer_channels(layer).size();
        layers.push_back({layer, picture.width, picture.height, static_cast<int>(channels), {}});
    }
    return layers;
}

void claim_values(std::vector<LayerImage>& layers, int threads, CancelFlag cancel) {
    for (LayerImage& layer : layers) {
        layer.values =
            claim_floats(static_cast<std::size_t>(layer.channels) * static_cast<std::size_t>(layer.width) *
                             static_cast<std::size_t>(layer.height),
                         threads, cancel);
    }
}

Rendering empty_rendering(const std::vector<Layer>& layers, const Crop& picture, int threads) {
    Rendering rendering;
    rendering.image = {picture.width, picture.height, claim_floats(count_numbers(picture), threads, nullptr)};
    rendering.layers = empty_layers(layers, picture);
    claim_values(rendering.layers, threads, nullptr);
    return rendering;
}

void copy_tile(const FinishedTile& tile, const Crop& picture, Rendering& rendering) {
    copy_rows(tile.rgb, tile.row_floats, 3, tile.area, picture, rendering.image.rgb);
    for (std::size_t i = 0; i < tile.layers.size(); ++i) {
        const TileLayer& layer = tile.layers[i];
        copy_rows(layer.values, layer.row_floats, static_cast<std::size_t>(layer.channels), tile.area,
                  picture, rendering.layers[i].values);
    }
}

void add_rays(RayCounts& sum, const RayCounts& rays) {
    sum.camera += rays.camera;
    sum.shadow += rays.shadow;
    sum.mirror += rays.mirror;
    sum.transmitted += rays.transmitted;
    sum.cut += rays.cut;
}

}  // namespace glint
