// SPDX-License-Identifier: Apache-2.0
// World -> Image: tiles to threads.
#include <algorithm>
#include <atomic>
#include <memory>

#include "base/catch_exceptions.h"
#include "base/huge_pages.h"
#include "base/parallel_for.h"
#include "glint/render.h"
#include "trace/kernels.h"

namespace glint {
namespace {

// Why a crop cannot be had, or nothing.
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

struct AtomicCounts {
    std::atomic<std::uint64_t> camera{0}, shadow{0}, mirror{0}, transmitted{0}, cut{0};
    void add(const RayCounts& counts) {
        camera += counts.camera;
        shadow += counts.shadow;
        mirror += counts.mirror;
        transmitted += counts.transmitted;
        cut += counts.cut;
    }
    RayCounts get() const { return {camera, shadow, mirror, transmitted, cut}; }
};

std::vector<LayerImage> empty_layers(const std::vector<Layer>& wanted, const Crop& crop) {
    std::vector<LayerImage> layers;
    for (const Layer layer : wanted) {
        const std::size_t channels = layer_infos()[static_cast<std::size_t>(layer)].channels.size();
        layers.push_back({layer, crop.width, crop.height, static_cast<int>(channels), {}});
        layers.back().values.resize(channels * static_cast<std::size_t>(crop.width) *
                                    static_cast<std::size_t>(crop.height));
    }
    return layers;
}

// Where a tile's layers go whose first pixel has this number in the image.
LayerTargets targets_at(std::vector<LayerImage>& layers, std::size_t pixel) {
    LayerTargets targets;
    for (LayerImage& layer : layers) {
        targets.data[static_cast<std::size_t>(layer.layer)] =
            layer.values.data() + static_cast<std::size_t>(layer.channels) * pixel;
    }
    return targets;
}

// Why these layers cannot be had, or nothing.
std::string layers_error(const std::vector<Layer>& layers) {
    bool wanted[k_layers] = {};
    for (const Layer layer : layers) {
        const auto l = static_cast<std::size_t>(layer);
        if (l >= k_layers) return "there is no such layer";
        if (wanted[l]) return "the layer '" + std::string(layer_infos()[l].name) + "' is asked for twice";
        wanted[l] = true;
    }
    return {};
}

void render_into(const WorldParts& world, const RenderOptions& options, const Kernels& kernels,
                 const Crop& crop, RenderResult& result) {
    Image image;
    image.width = crop.width;
    image.height = crop.height;
    const std::size_t numbers =
        3 * static_cast<std::size_t>(crop.width) * static_cast<std::size_t>(crop.height);
    image.rgb.reserve(numbers);
    advise_huge_pages(image.rgb.data(), numbers * sizeof(float));
    prefault_pages(image.rgb.data(), numbers * sizeof(float), result.threads);
    image.rgb.resize(numbers);

    const int across = (crop.width + k_tile_side - 1) / k_tile_side,
              down = (crop.height + k_tile_side - 1) / k_tile_side;
    const auto tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    std::vector<LayerImage> layers = empty_layers(options.layers, crop);
    AtomicCounts rays;
    std::atomic<std::size_t> done{0};
    const auto cancelled = [&] {
        return options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed);
    };
    parallel_for(tiles, result.threads, [&](std::size_t tile) {
        if (cancelled()) return;
        const int column = static_cast<int>(tile % static_cast<std::size_t>(across)) * k_tile_side;
        const int row = static_cast<int>(tile / static_cast<std::size_t>(across)) * k_tile_side;
        TileJob job;
        job.x = crop.x + column;
        job.y = crop.y + row;
        job.width = std::min(k_tile_side, crop.width - column);
        job.height = std::min(k_tile_side, crop.height - row);
        const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(crop.width) +
                                  static_cast<std::size_t>(column);
        job.rgb = image.rgb.data() + 3 * first;
        job.row_pixels = crop.width;
        const LayerTargets targets = targets_at(layers, first);
        if (!layers.empty()) job.layers = &targets;
        TileScratch& scratch = thread_scratch();
        scratch.counts = {};
        kernels.render_tile(world, job, scratch);
        rays.add(scratch.counts);
        const std::size_t now = ++done;
        if (options.progress) options.progress(static_cast<double>(now) / static_cast<double>(tiles));
    });
    result.rays = rays.get();
    if (done < tiles) {
        result.cancelled = true;
    } else {
        result.image = std::move(image);
        result.layers = std::move(layers);
    }
}

}  // namespace

RenderResult render(const World& rendered, const RenderOptions& options) {
    const WorldParts& world = rendered.parts();
    RenderResult result;
    const Kernels* kernels = find_kernels(options.isa);
    if (kernels == nullptr) {
        result.error = no_kernels_error(options.isa);
        return result;
    }
    const Crop crop = options.crop.value_or(Crop{world.settings.width, world.settings.height, 0, 0});
    result.error = crop_error(crop, world.settings);
    if (result.error.empty()) result.error = layers_error(options.layers);
    if (!result.error.empty()) return result;
    result.isa = kernels->isa;
    result.threads = thread_count(options.threads);
    result.error = catch_exceptions([&] { render_into(world, options, *kernels, crop, result); });
    if (!result.error.empty()) result.image.reset();
    return result;
}

std::vector<std::string> isa_names() {
    std::vector<std::string> names;
    for (const Kernels& k : available_kernels()) names.emplace_back(k.isa);
    return names;
}

}  // namespace glint
