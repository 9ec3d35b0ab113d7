// SPDX-License-Identifier: Apache-2.0
#pragma once
// Validation of a layer.
#include <string>

#include "glint/conventions.h"
#include "glint/layers.h"

namespace glint {

/// The reason why the layer's size, channels and values do not match, or an empty string.
inline std::string layer_fault(const LayerImage& layer) {
    const auto number = static_cast<std::size_t>(layer.layer);
    if (number >= k_layers) return "there is no such layer";
    const LayerInfo& info = layer_infos()[number];
    const std::string of = "the layer '" + std::string(info.name) + "'";
    if (layer.width < 1 || layer.height < 1 || layer.width > k_max_size || layer.height > k_max_size)
        return of + " has not 1 to " + std::to_string(k_max_size) + " pixels a side";
    if (layer.channels < 1 || static_cast<std::size_t>(layer.channels) != info.channels.size())
        return of + " has " + std::to_string(info.channels.size()) + " channels, not " +
               std::to_string(layer.channels);
    if (layer.values.size() !=
        info.channels.size() * static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height))
        return "the values of " + of + " do not fit its size";
    return {};
}

}  // namespace glint
