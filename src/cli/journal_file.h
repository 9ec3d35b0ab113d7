// SPDX-License-Identifier: Apache-2.0
#pragma once
// The journal of a render on the disk: finished tiles are appended while others are rendered.
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/interrupt.h"
#include "cli/journal_input.h"

namespace glint::cli {

class JournalFile {
  public:
    /// Goes on with the journal at `path`, or begins it. The file is locked while this lives. Throws Failure,
    /// and leaves the file alone, if another process uses it, if it is no journal, or one of another picture.
    static std::unique_ptr<JournalFile> resume(const std::string& path, const JournalHeader& header);

    /// Begins a journal in an unnamed place beside `target`; an interruption removes it. Throws Failure.
    static std::unique_ptr<JournalFile> begin(const std::string& target, const JournalHeader& header);

    ~JournalFile();
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    const JournalHeader& header() const { return header_; }
    /// How many tiles the part has, and which of them are not in the journal yet.
    std::size_t expected() const { return expected_; }
    const std::vector<std::uint32_t>& missing() const { return missing_; }

    /// Appends a tile's record (record_bytes()). After a failure this does nothing, and failed() is set. One
    /// call at a time.
    void append(std::string_view record);
    const std::atomic<bool>& failed() const { return failed_; }
    /// Throws the Failure of append(), if there was one.
    void rethrow() const;

    /// The rays of the tiles that were there at the beginning.
    const RayCounts& rays_before() const { return rays_before_; }

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
    int descriptor_ = -1, error_ = 0;
    RayCounts rays_before_;
    std::size_t expected_ = 0;
    std::vector<std::uint32_t> missing_;
    std::atomic<bool> failed_{false};
    std::chrono::steady_clock::time_point synced_;
    std::optional<UnfinishedFile> unfinished_;
};

}  // namespace glint::cli
