// SPDX-License-Identifier: Apache-2.0
// World -> Image: tiles to threads.
#include <algorithm>
#include <atomic>
#include <memory>

#include "base/huge_pages.h"
#include "base/one_at_a_time.h"
#include "base/parallel_for.h"
#include "base/status.h"
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

std::size_t count_numbers(const Crop& crop) {
    return 3 * static_cast<std::size_t>(crop.width) * static_cast<std::size_t>(crop.height);
}

std::vector<float> claim_pixels(std::size_t numbers, int threads) {
    std::vector<float> rgb;
    rgb.reserve(numbers);
    advise_huge_pages(rgb.data(), numbers * sizeof(float));
    prefault_pages(rgb.data(), numbers * sizeof(float), threads);
    rgb.resize(numbers);
    return rgb;
}

// Why the picture cannot go into the caller's memory, or nothing.
std::string pixels_error(const RenderOptions& options, const Crop& crop) {
    if (!options.pixels || options.pixels->size() == count_numbers(crop)) return {};
    return "the memory for the picture has " + std::to_string(options.pixels->size()) +
           " numbers, and a picture of " + std::to_string(crop.width) + "x" + std::to_string(crop.height) +
           " has " + std::to_string(count_numbers(crop));
}

// The caller's callbacks.
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
    result.threads = thread_count(options.threads);
    result.image.width = crop.width;
    result.image.height = crop.height;
    if (!options.pixels) result.image.rgb = claim_pixels(count_numbers(crop), result.threads);
    float* const rgb = options.pixels ? options.pixels->data() : result.image.rgb.data();

    const int across = (crop.width + k_tile_side - 1) / k_tile_side,
              down = (crop.height + k_tile_side - 1) / k_tile_side;
    const auto tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    result.layers = empty_layers(options.layers, crop);
    AtomicCounts rays;
    std::atomic<std::size_t> done{0};
    Reporter reporter(options, tiles);
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
        job.rgb = rgb + 3 * first;
        job.row_pixels = crop.width;
        const LayerTargets targets = targets_at(result.layers, first);
        if (!result.layers.empty()) job.layers = &targets;
        TileScratch& scratch = thread_scratch();
        scratch.counts = {};
        kernels.render_tile(world, job, scratch);
        rays.add(scratch.counts);
        ++done;
        reporter.report({{job.width, job.height, job.x, job.y}, job.rgb, 3 * std::size_t(crop.width)});
    });
    if (done < tiles) return glint::cancelled();
    result.rays = rays.get();
    return result;
}

}  // namespace

Result<Rendering> render(const World& rendered, const RenderOptions& options) {
    return result_of([&]() -> Result<Rendering> {
        const WorldParts& world = rendered.parts();
        const Kernels* kernels = find_kernels(options.isa);
        if (kernels == nullptr) return invalid_argument(no_kernels_error(options.isa));
        const Crop crop = options.crop.value_or(Crop{world.settings.width, world.settings.height, 0, 0});
        std::string wrong = crop_error(crop, world.settings);
        if (wrong.empty()) wrong = layers_error(options.layers);
        if (wrong.empty()) wrong = pixels_error(options, crop);
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        return render_picture(world, options, *kernels, crop);
    });
}

std::vector<std::string> isa_names() {
    std::vector<std::string> names;
    for (const Kernels& k : available_kernels()) names.emplace_back(k.isa);
    return names;
}

}  // namespace glint
