// SPDX-License-Identifier: Apache-2.0
#pragma once
// The journal of a render on the disk: finished tiles are appended while others are rendered.
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/interrupt.h"
#include "cli/journal_input.h"
#include "output/journal_sink.h"

namespace glint::cli {

class JournalFile : public RecordFile {
  public:
    /// Goes on with the journal at `path`, or begins it. The file is locked while this lives. Throws Failure,
    /// and leaves the file alone, if another process uses it, if it is no journal, or one of another picture.
    static std::unique_ptr<JournalFile> resume(const std::string& path, const JournalHeader& header);

    /// Begins a journal in an unnamed place beside `target`; an interruption removes it. Throws Failure.
    static std::unique_ptr<JournalFile> begin(const std::string& target, const JournalHeader& header);

    ~JournalFile() override;
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    const JournalHeader& header() const { return header_; }
    /// The tiles of the part that were not in the journal at the beginning.
    const std::vector<std::uint32_t>& missing() const { return missing_; }
    TileWork work() const { return {expected_, missing_.size(), rays_before_}; }

    /// Appends a tile's record (record_bytes()). One call at a time. Throws Failure.
    void append(std::string_view record) override;

    /// All that is in the file. Throws Failure.
    JournalInput read() const;

    /// Brings what was appended to the disk, and moves the journal to `target`. Throws Failure.
    void move_to(const std::string& target);
    void remove();

  private:
    JournalFile(std::string path, const JournalHeader& header);
    void lock();
    std::size_t read_tiles();
    void start();
    void write(std::string_view bytes);
    void sync();
    [[noreturn]] void fail(int error) const;

    const std::string path_;
    const JournalHeader header_;
    int descriptor_ = -1;
    RayCounts rays_before_;
    std::size_t expected_ = 0;
    std::vector<std::uint32_t> missing_;
    std::chrono::steady_clock::time_point synced_;
    std::optional<UnfinishedFile> unfinished_;
};

}  // namespace glint::cli
