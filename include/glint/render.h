// SPDX-License-Identifier: Apache-2.0
#pragma once
// World to Image.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glint/callback.h"
#include "glint/export.h"
#include "glint/image.h"
#include "glint/layers.h"
#include "glint/result.h"
#include "glint/scene.h"
#include "glint/tiles.h"
#include "glint/world.h"

namespace glint {

/// Raised whenever a change of glint changes the pixels of any picture. Tiles of programs with the same
/// number belong together.
inline constexpr std::uint32_t k_picture_version = 6;

struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, mirror = 0, transmitted = 0;
    std::uint64_t cut = 0;  ///< mirror and glass rays that were not traced because of k_max_sample_rays
    std::uint64_t total() const { return camera + shadow + mirror + transmitted; }
};

/// A layer of a tile.
struct TileLayer {
    Layer layer = Layer::background;
    int channels = 3;
    const float* values = nullptr;  ///< the channels of its top-left pixel, then those to the right of it
    std::size_t row_floats = 0;     ///< from a pixel's first channel to that of the pixel below it
};

/// A rectangle of the picture whose pixels are final.
struct FinishedTile {
    std::uint32_t number = 0;           ///< of count_tiles() of the picture or of the crop
    Crop area;                          ///< in the whole picture, whatever the crop is
    const float* rgb = nullptr;         ///< r, g, b of its top-left pixel, then those to the right of it
    std::size_t row_floats = 0;         ///< from a pixel's r to that of the pixel below it
    std::span<const TileLayer> layers;  ///< in the order of RenderOptions::layers
    RayCounts rays;                     ///< traced for this tile
};

struct RenderOptions {
    int threads = 0;                 ///< 0: one per processor (docs/library.md, Threads)
    std::string isa = {};            ///< one of isa_names(); empty: the best
    std::optional<Crop> crop = {};   ///< only this part of the picture; the Image has the crop's size
    std::vector<Layer> layers = {};  ///< what else is wanted, each once
    /// Where the threads get the numbers of tiles to render (glint/tiles.h), each number once, until it
    /// returns nothing; the other pixels are not written to. Threads call it at the same time, and it may
    /// wait. Must not throw. None: all tiles.
    Function<std::optional<std::uint32_t>()> next_tile = {};
    /// false: the pixels go to on_tile only. The Rendering's image and layers have sizes and no numbers, and
    /// the memory does not depend on the picture's size.
    bool keep_image = true;
    /// The caller's memory for the picture, 3 width height floats of the picture or of the crop: an error if
    /// it has another size. It is written to until render() returns; after a failure some tiles are drawn.
    std::optional<std::span<float>> pixels = {};
    /// Called with the fraction done (0 to 1), which grows from call to call. Must not throw.
    Function<void(double)> progress = {};
    /// Called with each tile as soon as it is rendered, in any order. Each pixel is in one tile. Must not
    /// throw.
    Function<void(const FinishedTile&)> on_tile = {};
    CancelFlag cancel = {};  ///< checked between tiles, and between samples of a tile
};
// progress and on_tile are called on the rendering threads, one call at a time. During a call the other
// threads continue, and wait only to make a call themselves.

struct Rendering {
    Image image;  ///< its size; no numbers with RenderOptions::pixels or without keep_image
    std::vector<LayerImage> layers;  ///< in the order of RenderOptions::layers
    bool has_alpha = false;          ///< RenderSettings::alpha: the picture is multiplied by Layer::alpha
    RayCounts rays;
    ByteRule rule;    ///< that of the World's conventions, for EncodeOptions::set_rule()
    std::string isa;  ///< the instruction set used
    int threads = 0;
};

/// Renders the picture. The same bits for any threads, instruction set and crop. Never throws.
GLINT_API Result<Rendering> render(const World& world, const RenderOptions& options = {});

/// The instruction sets that both machine and build support, best first. x86-64: "avx512", "avx2", "sse4",
/// "scalar"; arm64: "neon", "scalar"; the browser build: "scalar".
GLINT_API std::vector<std::string> isa_names();

}  // namespace glint
