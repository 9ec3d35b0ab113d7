// SPDX-License-Identifier: Apache-2.0
// Converts layers to pictures for display.
#include "image/layer_preview.h"

#include <algorithm>
#include <cmath>

#include "base/status.h"
#include "image/layer_fault.h"

namespace glint {
namespace {

// A distinct color for every number except 0; neighbours in the scene get different ones.
void put_id(float id, float* rgb) {
    std::fill_n(rgb, 3, 0.0f);
    if (!(id >= 1 && id < 0x1p32f)) return;
    std::uint32_t bits = static_cast<std::uint32_t>(id);
    bits *= 2654435769u;  // Knuth's multiplicative hashing
    for (int c = 0; c < 3; ++c) rgb[c] = static_cast<float>(64 + (bits >> (8 + 8 * c) & 0xbf)) / 255.0f;
}

}  // namespace

void LayerPreview::Range::add(float value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
}

float LayerPreview::Range::place(float value) const {
    return greatest > least ? (value - least) / (greatest - least) : value < least ? 0.0f : 1.0f;
}

void LayerPreview::scan(std::span<const float> values) {
    if (layer_ == Layer::position) {
        for (std::size_t i = 0; i < values.size(); ++i) ranges_[i % 3].add(values[i]);
    } else if (layer_ == Layer::depth) {
        for (const float value : values) ranges_[0].add(value);
    }
}

void LayerPreview::convert(std::span<const float> values, float* rgb) const {
    switch (layer_) {
        case Layer::normal:
            for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
                const float* n = values.data() + i;
                const bool is_hit = n[0] != 0 || n[1] != 0 || n[2] != 0;
                for (std::size_t c = 0; c < 3; ++c) rgb[i + c] = is_hit ? 0.5f * (n[c] + 1) : 0;
            }
            return;
        case Layer::position:
            for (std::size_t i = 0; i < values.size(); ++i) rgb[i] = ranges_[i % 3].place(values[i]);
            return;
        case Layer::object:
        case Layer::material:
            for (std::size_t p = 0; p < values.size(); ++p) put_id(values[p], rgb + 3 * p);
            return;
        case Layer::depth:
            for (std::size_t p = 0; p < values.size(); ++p) {
                const float value = values[p];
                std::fill_n(rgb + 3 * p, 3, std::isfinite(value) ? 1 - 0.9f * ranges_[0].place(value) : 0);
            }
            return;
        case Layer::shadow:
        case Layer::alpha:
            for (std::size_t p = 0; p < values.size(); ++p) std::fill_n(rgb + 3 * p, 3, values[p]);
            return;
        default:
            std::copy(values.begin(), values.end(), rgb);
    }
}

Result<Image> viewable(const LayerImage& layer) {
    return result_of([&]() -> Result<Image> {
        std::string wrong = layer_fault(layer);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        Image image{layer.width, layer.height, {}};
        image.rgb.resize(std::size_t{3} * static_cast<std::size_t>(layer.width) *
                         static_cast<std::size_t>(layer.height));
        LayerPreview preview(layer.layer);
        preview.scan(layer.values);
        preview.convert(layer.values, image.rgb.data());
        return image;
    });
}

}  // namespace glint
