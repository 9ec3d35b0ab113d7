// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tiles to a file, without the picture in memory: a row of tiles is encoded and written when it is complete.
#include <condition_variable>
#include <map>
#include <mutex>
#include <vector>

#include "output/strip_writer.h"
#include "output/tile_sink.h"

namespace glint {

/// Threads get tiles in order; one that would begin a row too far ahead waits until rows have been written,
/// so that the memory is that of a few rows. The rendering threads encode: before its next tile, a thread
/// encodes a complete row if there is one.
class StripSink : public TileSink {
  public:
    /// alpha: the picture's alpha channel is the last layer of the tiles. Other layers are left out. The
    /// writer must outlive this.
    StripSink(const Crop& picture, int threads, bool alpha, StripWriter& writer);

    std::optional<std::uint32_t> next_tile() override;
    void receive(const FinishedTile& tile) override;
    /// Ends the file, after all tiles. Throws if it cannot be written.
    void finish() { writer_.finish(false); }

  private:
    struct Row {
        std::vector<float> values;
        std::int64_t tiles = 0;
    };
    void write_row(std::unique_lock<std::mutex>& lock);
    void copy(const FinishedTile& tile, Row& row, const Crop& area) const;

    const Crop picture_;
    const bool alpha_;
    StripWriter& writer_;
    const std::int64_t across_, strips_, ahead_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::int64_t, Row> rows_, complete_;
    std::int64_t next_ = 0, written_ = 0;
};

}  // namespace glint
