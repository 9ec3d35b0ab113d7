// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tile: a rectangle of pixels whose rays go through the stages together.
#include <array>
#include <atomic>
#include <cstddef>

#include "glint/layers.h"
#include "glint/render.h"
#include "trace/batches.h"
#include "trace/surface_record.h"

namespace glint {

/// Camera rays are ordered in blocks of 8 x 8, so that packets of consecutive rays are coherent.
inline constexpr int k_tile_block = 8;

/// The floats of the pixels of a tile and of those around it: r, g, b and alpha.
inline constexpr std::size_t k_bordered_tile_floats = 4 * std::size_t{k_tile_side + 2} * (k_tile_side + 2);

struct TileRecord;

/// Column i and row j of a pixel's n x n samples.
struct SampleIndex {
    int i = 0, j = 0, n = 1;
    int number() const { return j * n + i; }
    bool is_middle() const { return i == n / 2 && j == n / 2; }
};

/// Pixels of the picture whose rays go through the stages together, in place of a whole tile. Their numbers
/// in the film are their positions in the list.
struct PixelList {
    int count = 0;
    StreamColumn<double> x, y;  // in the picture
    void add(int px, int py) {
        x[static_cast<std::size_t>(count)] = px;
        y[static_cast<std::size_t>(count)] = py;
        ++count;
    }
};

/// The destinations of the layers of a tile, like TileJob::rgb. Null: not requested.
struct LayerTargets {
    std::array<float*, k_layers> data{};
    int row_pixels = 1;
    float* of(Layer layer) const { return data[static_cast<std::size_t>(layer)]; }
};

struct TileJob {
    int x = 0, y = 0, width = 0, height = 0;  // pixels of the picture
    float* rgb = nullptr;  // a pixel of the tile is written to rgb[3 (row * row_pixels + column)]
    int row_pixels = 0;
    const LayerTargets* layers = nullptr;  // null: no layers requested
    CancelFlag cancel = {};                // checked between samples; null: never cancelled
    bool same_refinement = false;  // adaptive sampling: refines TileScratch::refined instead of choosing
};

/// The batches of a tile. A thread reuses them for its next tile.
struct TileScratch {
    RayBatch rays;  // the current generation
    HitBatch hits;
    SurfaceBatch surfaces;
    RadianceBatch radiance;
    LightSampleBatch light_samples;
    HighlightBatch highlights;
    ShadowRayBatch shadow_rays;
    SkyBatch sky;
    SkyGroup sky_group;
    AreaShadowBatch area_shadow;
    SecondaryRayBatch secondary;
    Film film;
    FirstHits first_hits;
    PixelList pixels;                        // for adaptive and jittered sampling only
    StreamColumn<std::uint32_t> pixel_hash;  // of the current sample, if hashes are wanted
    std::array<float, k_bordered_tile_floats> one_sample;
    PixelList refined;         // the pixels of the last tile that adaptive sampling refined
    SteppedRays stepped_rays;  // for transparent surfaces only

    int pixel_sample = 0;  // the number of the current sample of the pixels
    RayCounts counts;
    TileRecord* record = nullptr;  // records the stages of a one-pixel tile (trace/record.h); null: none
    SurfaceRecord* surface_record = nullptr;  // records surfaces instead of lighting them; null: none
    /// Whether all stages run even if no ray hits a shape.
    bool needs_every_stage() const { return record != nullptr || first_hits.wanted; }
};

}  // namespace glint
