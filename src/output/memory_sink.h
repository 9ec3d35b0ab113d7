// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tiles to a picture in memory. A render in one process needs no sink for that: render() writes each pixel to
// its place.
#include <atomic>
#include <vector>

#include "journal/header.h"
#include "output/tile_sink.h"

namespace glint {

class MemorySink : public RecordSink {
  public:
    /// Of the picture and the layers of the header, which must outlive this.
    MemorySink(const JournalHeader& header, int threads);

    std::optional<std::uint32_t> next_tile() override;
    void receive(const FinishedTile& tile) override;
    bool needs_checksums() const override { return false; }
    std::optional<RayCounts> receive_record(std::string record) override;

    /// Moves the pixels and the layers to the rendering.
    void move_to(Rendering& rendering);

  private:
    const JournalHeader& header_;
    Rendering picture_;
    std::atomic<std::size_t> next_{0};
};

}  // namespace glint
