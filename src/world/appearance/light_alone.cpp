// SPDX-License-Identifier: Apache-2.0
#include "world/appearance/light_alone.h"

#include <utility>

#include "world/appearance/prepare_sky.h"
#include "world/appearance/shading.h"

namespace glint {
namespace {

// Light that comes from no light.
void remove_other_light(WorldParts& world) {
    world.background = {0, 0, 0};
    set_gradient(std::nullopt, world);
    if (world.fog) world.fog->color = {0, 0, 0};
    const double direct = world.direct;
    set_occlusion(std::nullopt, world);
    world.direct = direct;
    world.extended_uses &= ~k_extended_field<&Material::emission>;
}

}  // namespace

std::size_t count_lights(const WorldParts& world) {
    return world.lights->size() + world.ambient_lights->size();
}

std::optional<WorldParts> world_of_layer(const WorldParts& world, Layer layer) {
    WorldParts changed = world;
    const std::optional<std::uint32_t> light = light_of(layer);
    PreparedLights lights;
    if (light) {
        const Shading shading = world.settings.shading;
        if (shading == Shading::color || shading == Shading::normals) return std::nullopt;
        remove_other_light(changed);
        for (const PreparedLight& one : *world.lights)
            if (one.index == *light) lights.lights.push_back(one);
        for (const AmbientLight& one : *world.ambient_lights)
            if (one.index == *light) lights.ambient = one.color;
    }
    set_lights(std::move(lights), changed);
    return changed;
}

}  // namespace glint
