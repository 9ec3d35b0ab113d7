// SPDX-License-Identifier: Apache-2.0
#pragma once
// Validation of a layer.
#include <string>

#include "glint/conventions.h"
#include "glint/layers.h"

namespace glint {

/// The reason why the layer's size, channels and values do not match, or an empty string.
inline std::string layer_fault(const LayerImage& layer) {
    const std::size_t channels = layer_channels(layer.layer).size();
    if (channels == 0) return "there is no such layer";
    const std::string of = "the layer '" + layer_name(layer.layer) + "'";
    if (layer.width < 1 || layer.height < 1 || layer.width > k_max_size || layer.height > k_max_size)
        return of + " has not 1 to " + std::to_string(k_max_size) + " pixels a side";
    if (layer.channels < 1 || static_cast<std::size_t>(layer.channels) != channels)
        return of + " has " + std::to_string(channels) + " channels, not " + std::to_string(layer.channels);
    if (layer.values.size() !=
        channels * static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height))
        return "the values of " + of + " do not fit its size";
    return {};
}

}  // namespace glint
