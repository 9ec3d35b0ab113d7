// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tiles to a journal.
#include <atomic>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "journal/header.h"
#include "output/tile_sink.h"

namespace glint {

/// The file of a journal, whose header and finished tiles have been written or read.
class RecordFile {
  public:
    virtual ~RecordFile() = default;
    /// Appends the record of a tile. Throws if it cannot.
    virtual void append(std::string_view record) = 0;
};

/// receive() and receive_record() keep records in memory until write_received(): bringing a file to the disk
/// takes time, in which whoever distributes tiles to other processes cannot wait.
class JournalSink : public RecordSink {
  public:
    /// missing: the tiles that the journal lacks. All must outlive this.
    JournalSink(const JournalHeader& header, const std::vector<std::uint32_t>& missing, const TileWork& work,
                RecordFile& file);

    std::optional<std::uint32_t> next_tile() override;
    void receive(const FinishedTile& tile) override;
    void write_received() override;
    bool needs_checksums() const override { return true; }
    std::optional<RayCounts> receive_record(std::string record) override;

  private:
    void add(std::string record);

    const JournalHeader& header_;
    const std::vector<std::uint32_t>& missing_;
    RecordFile& file_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::vector<std::string> received_;
};

}  // namespace glint
