// SPDX-License-Identifier: Apache-2.0
// Converts layers to pictures for display.
#include "glint/layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/status.h"
#include "image/layer_fault.h"

namespace glint {
namespace {

// The smallest and the largest finite value.
struct Range {
    float least = std::numeric_limits<float>::max(), greatest = std::numeric_limits<float>::lowest();
    void add(float value) {
        if (!std::isfinite(value)) return;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    // Maps the value to 0 to 1.
    float place(float value) const {
        return greatest > least ? (value - least) / (greatest - least) : value < least ? 0.0f : 1.0f;
    }
};

// A distinct colour for every number except 0; neighbours in the scene get different ones.
void put_id(float id, float* rgb) {
    if (!(id >= 1 && id < 0x1p32f)) return;
    std::uint32_t bits = static_cast<std::uint32_t>(id);
    bits *= 2654435769u;  // Knuth's multiplicative hashing
    for (int c = 0; c < 3; ++c) rgb[c] = static_cast<float>(64 + (bits >> (8 + 8 * c) & 0xbf)) / 255.0f;
}

void put_xyz(const LayerImage& layer, Image& image) {
    if (layer.layer == Layer::normal) {
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
            const float* n = layer.values.data() + i;
            if (n[0] == 0 && n[1] == 0 && n[2] == 0) continue;
            for (std::size_t c = 0; c < 3; ++c) image.rgb[i + c] = 0.5f * (n[c] + 1);
        }
        return;
    }
    Range ranges[3];
    for (std::size_t i = 0; i < image.rgb.size(); ++i) ranges[i % 3].add(layer.values[i]);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = ranges[i % 3].place(layer.values[i]);
}

Image picture_of(const LayerImage& layer) {
    Image image{layer.width, layer.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height);
    image.rgb.resize(3 * pixels);
    if (layer.layer == Layer::normal || layer.layer == Layer::position) {
        put_xyz(layer, image);
    } else if (layer.channels == 3) {
        image.rgb = layer.values;
    } else if (layer.layer == Layer::object || layer.layer == Layer::material) {
        for (std::size_t p = 0; p < pixels; ++p) put_id(layer.values[p], &image.rgb[3 * p]);
    } else {
        Range range;
        for (const float value : layer.values) range.add(value);
        for (std::size_t p = 0; p < pixels; ++p) {
            const float value = layer.values[p];
            const float grey = layer.layer == Layer::depth
                                   ? std::isfinite(value) ? 1 - 0.9f * range.place(value) : 0
                                   : value;
            std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * p), 3, grey);
        }
    }
    return image;
}

}  // namespace

Result<Image> viewable(const LayerImage& layer) {
    return result_of([&]() -> Result<Image> {
        std::string wrong = layer_fault(layer);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        return picture_of(layer);
    });
}

}  // namespace glint
