// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/color_maps.h"

#include <algorithm>

#include "scene/material_color.h"
#include "world/appearance/texture.h"

namespace glint::gltf_export {
namespace {

constexpr int k_places = 256;  // of u, to find a mean

// White for a picture below others.
TextureColor mean_color(const Texture& texture) {
    TextureColor sum{0, {}, 0};
    if (texture.image) return {0, {1, 1, 1}, 1};
    Texture whole = texture;
    whole.over = k_none;
    whole.wrap_u = whole.wrap_v = TextureWrap::clamp;
    const PreparedTexture prepared = prepare_textures({&whole, 1}).front();
    for (int i = 0; i < k_places; ++i) {
        const TextureSample sample = *sample_texture(prepared, {(i + 0.5) / k_places, 0});
        sum.color = sum.color + sample.color;
        sum.alpha += sample.alpha;
    }
    return {0, sum.color * (1.0 / k_places), texture.own_opacity(sum.alpha / k_places)};
}

// The material with the mean color of its texture, and of those that this one is over.
Material mean_material(const Scene& scene, const Material& material) {
    ShownTexture sum;
    double left = 1;
    for (std::uint32_t i = material.texture; i != k_none; i = scene.textures[i].over) {
        const Texture& texture = scene.textures[i];
        const TextureColor layer = mean_color(texture);
        const Color color = layer.color * (left * layer.alpha);
        sum.color = sum.color + color;
        sum.ambient = sum.ambient + color * texture.ambient;
        sum.diffuse = sum.diffuse + color * texture.diffuse;
        left -= left * layer.alpha;
    }
    sum.alpha = 1 - left;
    for (Color* const color : {&sum.color, &sum.ambient, &sum.diffuse})
        if (left < 1) *color = *color * (1 / sum.alpha);
    Material mean = with_texture(material, scene.textures[material.texture], sum);
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
        if (is_map(material)) material = mean_material(scene, material);
    }
    return changed;
}

}  // namespace glint::gltf_export
