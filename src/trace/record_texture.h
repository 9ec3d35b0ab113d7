// SPDX-License-Identifier: Apache-2.0
#pragma once
// What explain() says of a texture at a point.
#include <optional>

#include "glint/explain.h"
#include "world/appearance/appearance.h"

namespace glint {

/// Nothing if the surface has no texture there.
inline std::optional<ExplainedTexture> recorded_texture(const WorldParts& world, SurfaceId id, Vec3 point) {
    ExplainedTexture explained;
    const std::optional<TextureSample> sample = surface_texture(world, id, point);
    if (!sample) return std::nullopt;
    explained.texture =
        static_cast<std::uint32_t>(world.texture_of(material_row(world, id)) - world.textures->data());
    explained.u = sample->place.u, explained.v = sample->place.v;
    explained.column = sample->columns[0], explained.next_column = sample->columns[1];
    explained.row = sample->rows[0], explained.next_row = sample->rows[1];
    explained.next_column_weight = sample->right, explained.next_row_weight = sample->lower;
    explained.color = sample->color;
    explained.alpha = sample->alpha;
    return explained;
}

}  // namespace glint
