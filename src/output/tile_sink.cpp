// SPDX-License-Identifier: Apache-2.0
#include "output/tile_sink.h"

#include <utility>

#include "trace/film/assemble.h"

namespace glint {

void TileSink::rethrow() const {
    if (failed_) std::rethrow_exception(failure_);
}

void TileSink::fail(std::exception_ptr failure) {
    const std::scoped_lock lock(failing_);
    if (failed_) return;
    failure_ = std::move(failure);
    failed_ = true;
}

Result<Rendering> render_into(TileSink& sink, const World& world, RenderOptions options) {
    const TileWork& work = sink.work();
    std::size_t there = work.expected - work.missing;
    const auto progress = std::exchange(options.progress, {});
    options.keep_image = false;
    options.next_tile = [&sink] { return sink.next_tile(); };
    options.on_tile = [&](const FinishedTile& tile) {
        sink.receive(tile);
        sink.write_received();
        if (progress) progress(static_cast<double>(++there) / static_cast<double>(work.expected));
    };
    options.cancel = &sink.failed();
    Result<Rendering> result = render(world, options);
    sink.rethrow();
    if (result) add_rays(result->rays, work.rays_before);
    return result;
}

}  // namespace glint
