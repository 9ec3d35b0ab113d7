// SPDX-License-Identifier: Apache-2.0
#include "output/journal_sink.h"

#include <exception>
#include <utility>

#include "journal/journal.h"

namespace glint {

JournalSink::JournalSink(const JournalHeader& header, const std::vector<std::uint32_t>& missing,
                         const TileWork& work, RecordFile& file)
    : RecordSink(work), header_(header), missing_(missing), file_(file) {}

std::optional<std::uint32_t> JournalSink::next_tile() {
    const std::size_t i = next_++;
    if (i >= missing_.size()) return std::nullopt;
    return missing_[i];
}

void JournalSink::receive(const FinishedTile& tile) { add(record_bytes(tile)); }

std::optional<RayCounts> JournalSink::receive_record(std::string record) {
    const auto tile = parse_unchecked_record(record, header_);
    if (!tile) return std::nullopt;
    const RayCounts rays = tile->rays;
    add(std::move(record));
    return rays;
}

void JournalSink::add(std::string record) {
    const std::scoped_lock lock(mutex_);
    received_.push_back(std::move(record));
}

void JournalSink::write_received() {
    std::vector<std::string> records;
    {
        const std::scoped_lock lock(mutex_);
        records.swap(received_);
    }
    try {
        for (const std::string& record : records) {
            if (failed()) return;
            file_.append(record);
        }
    } catch (...) {
        fail(std::current_exception());
    }
}

}  // namespace glint
