// SPDX-License-Identifier: Apache-2.0
#pragma once
// A Rendering from its tiles: its memory, the tiles written into it, and the sum of their rays.
#include <atomic>
#include <vector>

#include "glint/render.h"

namespace glint {

/// How many floats a picture of this size has.
std::size_t count_numbers(const Crop& picture);

/// So many floats, all 0. Many are in large pages, which `threads` threads fill. Fewer if `cancel`, which may
/// be null, becomes true: gigabytes take seconds.
std::vector<float> claim_floats(std::size_t count, int threads, CancelFlag cancel);

/// Layers of this size without values.
std::vector<LayerImage> empty_layers(const std::vector<Layer>& wanted, const Crop& picture);
/// Gives them their values, as claim_floats() does.
void claim_values(std::vector<LayerImage>& layers, int threads, CancelFlag cancel);

/// A black picture, and its layers, all 0.
Rendering empty_rendering(const std::vector<Layer>& layers, const Crop& picture, int threads);

/// Writes a tile into the rendering of `picture`, which has the tile's layers. Tiles may be written at the
/// same time.
void copy_tile(const FinishedTile& tile, const Crop& picture, Rendering& rendering);

/// Adds the rays of a tile.
void add_rays(RayCounts& sum, const RayCounts& rays);

}  // namespace glint
