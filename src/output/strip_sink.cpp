// SPDX-License-Identifier: Apache-2.0
#include "output/strip_sink.h"

#include <algorithm>
#include <exception>

#include "base/parallel_for.h"

namespace glint {

StripSink::StripSink(const Crop& picture, int threads, bool alpha, StripWriter& writer)
    : TileSink({count_tiles(picture), count_tiles(picture), {}}),
      picture_(picture),
      alpha_(alpha),
      writer_(writer),
      across_((picture.width - 1) / k_tile_side + 1),
      strips_(count_strips(picture.height)),
      // Enough for all threads to have tiles while the slowest tile of the first row is rendered.
      ahead_(4 + (4 * std::int64_t{thread_count(threads)} - 1) / across_) {}

std::optional<std::uint32_t> StripSink::next_tile() {
    std::unique_lock lock(mutex_);
    for (;;) {
        if (failed()) return std::nullopt;
        if (!complete_.empty()) {
            write_row(lock);
        } else if (next_ == across_ * strips_) {
            return std::nullopt;
        } else if (next_ / across_ < written_ + ahead_) {
            return static_cast<std::uint32_t>(next_++);
        } else {
            changed_.wait(lock);
        }
    }
}

void StripSink::receive(const FinishedTile& tile) {
    const std::int64_t strip = tile.number / across_;
    Row& row = rows_[strip];  // only this function uses rows_, and one call of it at a time
    try {
        copy(tile, row, strip_area(picture_, static_cast<std::int32_t>(strip)));
    } catch (...) {
        fail(std::current_exception());
        const std::scoped_lock lock(mutex_);
        changed_.notify_all();  // the row will never be complete, and others may wait for it
        return;
    }
    if (++row.tiles < across_) return;
    const std::scoped_lock lock(mutex_);
    complete_.insert(rows_.extract(strip));
    changed_.notify_all();
}

void StripSink::copy(const FinishedTile& tile, Row& row, const Crop& area) const {
    const std::size_t channels = alpha_ ? 4 : 3;
    if (row.values.empty())
        row.values.resize(channels * static_cast<std::size_t>(area.width) *
                          static_cast<std::size_t>(area.height));
    for (std::int32_t y = 0; y < tile.area.height; ++y) {
        const auto tile_row = static_cast<std::size_t>(y);
        const auto width = static_cast<std::size_t>(tile.area.width);
        const std::span<const float> rgb(tile.rgb + tile_row * tile.row_floats, 3 * width);
        float* to = row.values.data() + channels * (tile_row * static_cast<std::size_t>(area.width) +
                                                    static_cast<std::size_t>(tile.area.x - area.x));
        if (alpha_) {
            const TileLayer& alpha = tile.layers.back();
            const auto rgba = with_alpha(rgb, {alpha.values + tile_row * alpha.row_floats, width});
            std::copy(rgba.begin(), rgba.end(), to);
        } else {
            std::copy(rgb.begin(), rgb.end(), to);
        }
    }
}

// Encodes the first complete row without the lock, which it has again at the end.
void StripSink::write_row(std::unique_lock<std::mutex>& lock) {
    const auto row = complete_.extract(complete_.begin());
    lock.unlock();
    try {
        writer_.put(static_cast<std::int32_t>(row.key()), row.mapped().values);
    } catch (...) {
        fail(std::current_exception());
    }
    lock.lock();
    ++written_;
    changed_.notify_all();
}

}  // namespace glint
