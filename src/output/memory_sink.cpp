// SPDX-License-Identifier: Apache-2.0
#include "output/memory_sink.h"

#include <utility>

#include "base/parallel_for.h"
#include "journal/journal.h"
#include "trace/film/assemble.h"

namespace glint {

MemorySink::MemorySink(const JournalHeader& header, int threads)
    : RecordSink({count_tiles(header.picture), count_tiles(header.picture), {}}),
      header_(header),
      picture_(empty_rendering(header.layers, header.picture, thread_count(threads))) {}

std::optional<std::uint32_t> MemorySink::next_tile() {
    const std::size_t tile = next_++;
    if (tile >= work().expected) return std::nullopt;
    return static_cast<std::uint32_t>(tile);
}

// Tiles have no pixel in common, so these two need no lock.
void MemorySink::receive(const FinishedTile& tile) { copy_tile(tile, header_.picture, picture_); }

std::optional<RayCounts> MemorySink::receive_record(std::string record) {
    const auto tile = parse_unchecked_record(record, header_);
    if (!tile) return std::nullopt;
    copy_tile(*tile, header_, picture_);
    return tile->rays;
}

void MemorySink::move_to(Rendering& rendering) {
    rendering.image = std::move(picture_.image);
    rendering.layers = std::move(picture_.layers);
}

}  // namespace glint
