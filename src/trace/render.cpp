// SPDX-License-Identifier: Apache-2.0
// World to Image: distributes tiles to threads.
#include <algorithm>
#include <atomic>
#include <memory>
#include <set>

#include "base/memory_limit.h"
#include "base/one_at_a_time.h"
#include "base/parallel_for.h"
#include "base/status.h"
#include "glint/render.h"
#include "trace/film/assemble.h"
#include "trace/film/light_layers.h"
#include "trace/kernels.h"
#include "world/appearance/light_alone.h"

namespace glint {
namespace {

// The error of an invalid crop, or an empty string.
std::string crop_error(const Crop& c, const RenderSettings& settings) {
    if (c.width < 1 || c.height < 1 || c.x < 0 || c.y < 0 || c.x > settings.width - c.width ||
        c.y > settings.height - c.height) {
        return "the crop is not within the picture";
    }
    return {};
}

TileScratch& thread_scratch() {
    thread_local const auto scratch = std::make_unique<TileScratch>();
    return *scratch;
}

// Where the kernels write a tile.
struct TileTargets {
    float* rgb = nullptr;
    int row_pixels = 0;
    LayerTargets layers;
    bool has_layers = false;       // other than those of lights
    std::vector<float*> lights;    // the layers of lights, in their order
    std::vector<TileLayer> parts;  // all, as on_tile gets them

    void add(const LayerImage& layer, float* values) {
        if (is_light_layer(layer.layer)) {
            lights.push_back(values);
        } else {
            layers.data[static_cast<std::size_t>(layer.layer)] = values;
            layers.row_pixels = row_pixels;
            has_layers = true;
        }
        parts.push_back({layer.layer, layer.channels, values,
                         static_cast<std::size_t>(layer.channels) * static_cast<std::size_t>(row_pixels)});
    }
};

// In the image, of which the tile's first pixel has this number.
TileTargets targets_in_image(float* rgb, std::vector<LayerImage>& layers, const Crop& crop,
                             std::size_t pixel) {
    TileTargets targets{rgb + 3 * pixel, crop.width, {}, false, {}, {}};
    for (LayerImage& layer : layers)
        targets.add(layer, layer.values.data() + static_cast<std::size_t>(layer.channels) * pixel);
    return targets;
}

// In memory of the thread's own, which the thread's next tile uses again.
TileTargets targets_in_thread(std::vector<LayerImage>& layers) {
    thread_local std::vector<float> memory;
    std::size_t floats = 3;
    for (const LayerImage& layer : layers) floats += static_cast<std::size_t>(layer.channels);
    memory.resize(floats * k_tile_pixels);
    TileTargets targets{memory.data(), k_tile_side, {}, false, {}, {}};
    float* next = memory.data() + 3 * k_tile_pixels;
    for (const LayerImage& layer : layers) {
        targets.add(layer, next);
        next += static_cast<std::size_t>(layer.channels) * k_tile_pixels;
    }
    return targets;
}

// The error of an invalid list of layers, or an empty string.
std::string layers_error(const WorldParts& world, const std::vector<Layer>& layers) {
    const std::size_t lights = count_lights(world);
    std::set<Layer> wanted;
    for (const Layer layer : layers) {
        if (layer_channels(layer).empty()) return "there is no such layer";
        const std::optional<std::uint32_t> light = light_of(layer);
        if (light && *light >= lights)
            return "there is no light " + std::to_string(*light + 1) + " for the layer '" +
                   layer_name(layer) + "': the scene has " + std::to_string(lights);
        if (!wanted.insert(layer).second) return "the layer '" + layer_name(layer) + "' is asked for twice";
    }
    return {};
}

// The error if the caller's memory has the wrong size, or an empty string.
std::string pixels_error(const RenderOptions& options, const Crop& crop) {
    if (options.pixels && !options.keep_image) return "pixels are given, and keep_image is false";
    if (!options.pixels || options.pixels->size() == count_numbers(crop)) return {};
    return "the memory for the picture has " + std::to_string(options.pixels->size()) +
           " numbers, and a picture of " + std::to_string(crop.width) + "x" + std::to_string(crop.height) +
           " has " + std::to_string(count_numbers(crop));
}

// "out of memory: 65536x65536 pixels need 48 GiB"
std::string memory_error(const RenderOptions& options, const Crop& crop) {
    std::uint64_t floats = options.pixels ? 0 : 3;
    for (const Layer layer : options.layers) floats += layer_channels(layer).size();
    if (floats == 0) return "out of memory";
    return "out of memory: " + std::to_string(crop.width) + "x" + std::to_string(crop.height) +
           " pixels need " + memory_text(floats * (count_numbers(crop) / 3) * sizeof(float));
}

// Calls the caller's callbacks, one at a time.
class Reporter {
  public:
    Reporter(const RenderOptions& options, std::size_t tiles)
        : options_(options), tiles_(static_cast<double>(tiles)) {}

    void report(const FinishedTile& tile) {
        if (!options_.progress && !options_.on_tile) return;
        calls_.run([&] {
            if (options_.on_tile) options_.on_tile(tile);
            if (options_.progress) options_.progress(++done_ / tiles_);
        });
    }

  private:
    const RenderOptions& options_;
    OneAtATime calls_;
    double done_ = 0;
    const double tiles_;
};

Result<Rendering> render_picture(const WorldParts& world, const RenderOptions& options,
                                 const Kernels& kernels, const Crop& crop) {
    Rendering result;
    result.isa = kernels.isa;
    result.rule = world.conventions.byte_rule();
    result.has_alpha = world.settings.alpha;
    result.threads = thread_count(options.threads);
    result.image.width = crop.width;
    result.image.height = crop.height;
    if (!options.pixels && options.keep_image)
        result.image.rgb = claim_floats(count_numbers(crop), result.threads, options.cancel);
    float* const rgb = options.pixels ? options.pixels->data() : result.image.rgb.data();

    const std::size_t tiles = count_tiles(crop);
    result.layers = empty_layers(options.layers, crop);
    if (options.keep_image) claim_values(result.layers, result.threads, options.cancel);
    const LightLayers light_layers(world, options.layers);
    OneAtATime counting;
    std::atomic<bool> stopped{false};
    std::atomic<std::int64_t> no_tile{-1};  // a number that next_tile gave and no tile has
    Reporter reporter(options, tiles);
    const auto cancelled = [&] {
        if (options.cancel.is_set()) stopped = true;
        return stopped.load(std::memory_order_relaxed);
    };
    if (cancelled()) return glint::cancelled();
    const auto render_one = [&](std::size_t tile) {
        const Crop area = tile_area(crop, tile);
        TileJob job;
        job.x = area.x;
        job.y = area.y;
        job.width = area.width;
        job.height = area.height;
        const std::size_t first =
            static_cast<std::size_t>(area.y - crop.y) * static_cast<std::size_t>(crop.width) +
            static_cast<std::size_t>(area.x - crop.x);
        const TileTargets targets = options.keep_image ? targets_in_image(rgb, result.layers, crop, first)
                                                       : targets_in_thread(result.layers);
        job.rgb = targets.rgb;
        job.row_pixels = targets.row_pixels;
        if (targets.has_layers) job.layers = &targets.layers;
        job.cancel = options.cancel;
        TileScratch& scratch = thread_scratch();
        scratch.counts = {};
        kernels.render_tile(world, job, scratch);
        if (!cancelled()) light_layers.render_tile(kernels, job, targets.lights, scratch);
        if (cancelled()) return;  // the tile need not be finished
        counting.run([&] { add_rays(result.rays, scratch.counts); });
        reporter.report({static_cast<std::uint32_t>(tile), area, job.rgb,
                         3 * static_cast<std::size_t>(job.row_pixels), targets.parts, scratch.counts});
    };
    if (options.next_tile) {
        const auto threads = static_cast<std::size_t>(result.threads);
        parallel_for(threads, result.threads, [&](std::size_t) {
            while (!cancelled()) {
                const std::optional<std::uint32_t> tile = options.next_tile();
                if (!tile) return;
                if (*tile >= tiles) {
                    no_tile = *tile;
                    stopped = true;
                    return;
                }
                render_one(*tile);
            }
        });
    } else {
        parallel_for(tiles, result.threads, [&](std::size_t tile) {
            if (!cancelled()) render_one(tile);
        });
    }
    if (no_tile >= 0) {
        return invalid_argument("next_tile gave " + std::to_string(no_tile) + ", and the picture has " +
                                std::to_string(tiles) + " tiles");
    }
    if (stopped) return glint::cancelled();
    return result;
}

}  // namespace

Result<Rendering> render(const World& rendered, const RenderOptions& options) {
    Crop crop;
    Result<Rendering> result = result_of([&]() -> Result<Rendering> {
        const WorldParts& world = rendered.parts();
        const Kernels* kernels = find_kernels(options.isa);
        if (kernels == nullptr) return invalid_argument(no_kernels_error(options.isa));
        crop = options.crop.value_or(Crop{world.settings.width, world.settings.height, 0, 0});
        std::string wrong = crop_error(crop, world.settings);
        if (wrong.empty()) wrong = layers_error(world, options.layers);
        if (wrong.empty()) wrong = pixels_error(options, crop);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        return render_picture(world, options, *kernels, crop);
    });
    if (result.code == ErrorCode::out_of_memory && options.keep_image) {
        return result_of([&]() -> Result<Rendering> {
            return failure(ErrorCode::out_of_memory, memory_error(options, crop));
        });
    }
    return result;
}

std::vector<std::string> isa_names() {
    std::vector<std::string> names;
    for (const Kernels& k : available_kernels()) names.emplace_back(k.isa);
    return names;
}

}  // namespace glint
