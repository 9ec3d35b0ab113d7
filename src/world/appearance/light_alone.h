// SPDX-License-Identifier: Apache-2.0
#pragma once
// The Worlds of the layers that show one light.
#include <cstddef>
#include <optional>

#include "glint/layers.h"
#include "world/world.h"

namespace glint {

/// The number of lights that the World was prepared with, ambient ones included.
std::size_t count_lights(const WorldParts& world);

/// The World of a light_layer(), whose light must exist: all other lights, the background, the emission, the
/// light from all directions and the fog's color are black. Of no_light: the lights alone are black. Nothing
/// if the layer is black because the shading mode is unlit.
std::optional<WorldParts> world_of_layer(const WorldParts& world, Layer layer);

}  // namespace glint
