// SPDX-License-Identifier: Apache-2.0
#include "trace/surface_record.h"

#include <algorithm>
#include <memory>

#include "base/parallel_for.h"
#include "trace/kernels.h"

namespace glint {
namespace {

constexpr std::size_t k_pixels_at_once = k_stream_size;

// Lists the pixels from number `first` on. Returns how many.
std::size_t list_pixels(const PixelPositions& pixels, std::size_t first, PixelList& list) {
    const std::size_t count = std::min(k_pixels_at_once, pixels.size() - first);
    const auto from = static_cast<std::ptrdiff_t>(first);
    std::copy_n(pixels.x.begin() + from, count, list.x.begin());
    std::copy_n(pixels.y.begin() + from, count, list.y.begin());
    list.count = static_cast<int>(count);
    return count;
}

}  // namespace

RayList camera_rays(const WorldParts& world, const PixelPositions& pixels) {
    const Kernels& kernels = available_kernels().front();
    const auto list = std::make_unique<PixelList>();
    RayBatch rays;
    RayList found;
    for (std::size_t first = 0; first < pixels.size(); first += k_pixels_at_once) {
        list_pixels(pixels, first, *list);
        kernels.make_pixel_rays(world, *list, rays);
        for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i)
            found.add({rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]},
                      {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}, rays.t_min[i]);
    }
    return found;
}

SurfaceRecord follow_pixels(const WorldParts& world, const PixelPositions& pixels, std::size_t generations,
                            int threads) {
    const Kernels& kernels = available_kernels().front();
    const std::size_t chunks = (pixels.size() + k_pixels_at_once - 1) / k_pixels_at_once;
    std::vector<SurfaceRecord> records(chunks, SurfaceRecord(generations));
    parallel_for(chunks, threads, [&](std::size_t chunk) {
        thread_local const auto scratch = std::make_unique<TileScratch>();
        const std::size_t first = chunk * k_pixels_at_once;
        list_pixels(pixels, first, scratch->pixels);
        kernels.follow_pixels(world, *scratch, records[chunk]);
        for (std::vector<SurfaceHit>& hits : records[chunk])
            for (SurfaceHit& hit : hits) hit.ray += first;
    });
    SurfaceRecord found(generations);
    for (SurfaceRecord& record : records) {
        for (std::size_t g = 0; g < generations; ++g)
            found[g].insert(found[g].end(), record[g].begin(), record[g].end());
        record = {};
    }
    return found;
}

}  // namespace glint
