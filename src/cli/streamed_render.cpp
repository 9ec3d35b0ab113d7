// SPDX-License-Identifier: Apache-2.0
#include "cli/streamed_render.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "base/parallel_for.h"

namespace glint::cli {
namespace {

// Rows of tiles between their first tile and the file. Threads take tiles in order; one that would begin a
// row too far ahead waits until rows have been written.
class Rows {
  public:
    Rows(const Crop& picture, int threads, bool alpha, StripFile& file)
        : picture_(picture),
          alpha_(alpha),
          file_(file),
          across_((picture.width - 1) / k_tile_side + 1),
          strips_(count_strips(picture.height)),
          // Enough for all threads to have tiles while the slowest tile of the first row is rendered.
          ahead_(4 + (4 * threads - 1) / across_) {}

    // A tile to render. Encodes a complete row first, if there is one.
    std::optional<std::uint32_t> next_tile() {
        std::unique_lock lock(mutex_);
        for (;;) {
            if (failed_) return std::nullopt;
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

    void add(const FinishedTile& tile) {
        const std::int64_t strip = tile.number / across_;
        Row& row = rows_[strip];  // only this function uses rows_, and one call of it at a time
        const Crop area = strip_area(picture_, static_cast<std::int32_t>(strip));
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
        if (++row.tiles < across_) return;
        const std::scoped_lock lock(mutex_);
        complete_.insert(rows_.extract(strip));
        changed_.notify_all();
    }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }
    const std::atomic<bool>& failed() const { return failed_; }

  private:
    struct Row {
        std::vector<float> values;
        std::int64_t tiles = 0;
    };

    // Encodes the first complete row without the lock, which it has again at the end.
    void write_row(std::unique_lock<std::mutex>& lock) {
        const auto row = complete_.extract(complete_.begin());
        lock.unlock();
        std::exception_ptr failure;
        try {
            file_.put(static_cast<std::int32_t>(row.key()), row.mapped().values);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        ++written_;
        if (failure) {
            failure_ = failure;
            failed_ = true;
        }
        changed_.notify_all();
    }

    const Crop picture_;
    const bool alpha_;
    StripFile& file_;
    const std::int64_t across_, strips_, ahead_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::int64_t, Row> rows_, complete_;
    std::int64_t next_ = 0, written_ = 0;
    std::exception_ptr failure_;
    std::atomic<bool> failed_{false};
};

}  // namespace

Result<Rendering> render_strips(const World& world, RenderOptions options, const Crop& picture,
                                StripFile& file) {
    const bool alpha = !options.layers.empty() && options.layers.back() == Layer::alpha;
    Rows rows(picture, thread_count(options.threads), alpha, file);
    options.keep_image = false;
    options.next_tile = [&rows] { return rows.next_tile(); };
    options.on_tile = [&rows](const FinishedTile& tile) { rows.add(tile); };
    options.cancel = &rows.failed();
    Result<Rendering> result = render(world, options);
    rows.rethrow();
    return result;
}

}  // namespace glint::cli
