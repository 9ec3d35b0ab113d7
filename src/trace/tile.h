// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tile: a fixed number of pixels whose rays go through the stages together.
#include <array>
#include <cstddef>

#include "glint/layers.h"
#include "glint/render.h"
#include "trace/batches.h"

namespace glint {

/// Camera rays are ordered in blocks of 8 x 8, so that neighbours are traced together.
inline constexpr int k_tile_block = 8;

struct TileRecord;

/// Where the layers of a tile go, as its rgb does; null: not asked for.
struct LayerTargets {
    std::array<float*, k_layers> data{};
    float* of(Layer layer) const { return data[static_cast<std::size_t>(layer)]; }
};

struct TileJob {
    int x = 0, y = 0, width = 0, height = 0;  // pixels of the picture
    float* rgb = nullptr;  // pixel (x, y) of the tile goes to rgb[3 (row * row_pixels + column)]
    int row_pixels = 0;
    const LayerTargets* layers = nullptr;  // what else is asked for
};

/// The batches of a tile, reused from tile to tile by one thread.
struct TileScratch {
    RayBatch rays;  // the generation at hand
    HitBatch hits;
    SurfaceBatch surfaces;
    RadianceBatch radiance;
    LightSampleBatch light_samples;
    HighlightBatch highlights;
    ShadowRayBatch shadow_rays;
    SecondaryRayBatch secondary;
    Film film;
    FirstHits first_hits;

    RayCounts counts;
    TileRecord* record = nullptr;  // where a tile of one pixel records what its stages do (trace/record.h)
    /// Whether all stages are run even if nothing is hit.
    bool needs_every_stage() const { return record != nullptr || first_hits.wanted; }
};

}  // namespace glint
