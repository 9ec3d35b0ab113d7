// SPDX-License-Identifier: Apache-2.0
#pragma once
// What explain() says of a texture at a point.
#include <optional>

#include "glint/explain.h"
#include "world/appearance/appearance.h"

namespace glint {

inline ExplainedTexture explained_texture(std::uint32_t texture, const TextureSample& sample) {
    ExplainedTexture explained;
    explained.texture = texture;
    explained.u = sample.place.u, explained.v = sample.place.v;
    explained.column = sample.columns[0], explained.next_column = sample.columns[1];
    explained.row = sample.rows[0], explained.next_row = sample.rows[1];
    explained.next_column_weight = sample.right, explained.next_row_weight = sample.lower;
    explained.color = sample.color;
    explained.alpha = sample.alpha;
    explained.ambient = sample.ambient, explained.diffuse = sample.diffuse;
    return explained;
}

/// Nothing if the surface has no texture there.
inline std::optional<ExplainedTexture> recorded_texture(const WorldParts& world, SurfaceId id, Vec3 point) {
    const std::optional<TextureSample> sample = surface_texture(world, id, point);
    if (!sample) return std::nullopt;
    const PreparedTexture& texture = *world.texture_of(material_row(world, id));
    ExplainedTexture explained = explained_texture(world.index_of(texture), *sample);
    if (texture.over == k_none) return explained;
    std::vector<TextureLayer> layers;
    sample_layers(*world.geometry, *world.textures, explained.texture, id, point, &layers);
    for (const TextureLayer& layer : layers) {
        ExplainedTexture& added =
            explained.layers.emplace_back(explained_texture(layer.texture, layer.sample));
        added.is_layer = true;
        added.weight = layer.weight;
    }
    return explained;
}

}  // namespace glint
