// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/color_maps.h"

#include <algorithm>

#include "scene/material_color.h"
#include "world/appearance/texture.h"

namespace glint::gltf_export {
namespace {

constexpr int k_places = 256;  // of u, to find a mean

// The material with the mean color of its texture.
Material mean_material(const Material& material, const Texture& texture) {
    Texture whole = texture;
    whole.wrap_u = whole.wrap_v = TextureWrap::clamp;
    const PreparedTexture prepared = prepare_textures({&whole, 1}).front();
    TextureColor sum{0, {}, 0};
    for (int i = 0; i < k_places; ++i) {
        const TextureSample sample = *sample_texture(prepared, {(i + 0.5) / k_places, 0});
        sum.color = sum.color + sample.color;
        sum.alpha += sample.alpha;
    }
    Material mean = with_texture(material, texture, sum.color * (1.0 / k_places), sum.alpha / k_places);
    mean.texture = k_none;
    return mean;
}

}  // namespace

std::optional<Scene> with_mean_colors(const Scene& scene, Losses& losses) {
    const auto is_map = [&](const Material& m) {
        return m.texture != k_none && !scene.textures[m.texture].image;
    };
    if (std::none_of(scene.materials.begin(), scene.materials.end(), is_map)) return std::nullopt;
    losses.add("patterns and maps of colors (`color_map`)", "the surfaces have their mean color");
    std::optional<Scene> changed = scene;
    for (Material& material : changed->materials) {
        if (is_map(material)) material = mean_material(material, scene.textures[material.texture]);
    }
    return changed;
}

}  // namespace glint::gltf_export
