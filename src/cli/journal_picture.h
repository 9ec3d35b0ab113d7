// SPDX-License-Identifier: Apache-2.0
#pragma once
// The picture whose tiles are in journals.
#include <functional>
#include <span>
#include <vector>

#include "cli/journal_input.h"

namespace glint::cli {

class JournalPicture {
  public:
    /// The journals belong to one picture, and must outlive this. Throws Failure if a tile of one differs
    /// from that of another.
    explicit JournalPicture(const std::vector<JournalInput>& inputs);

    const JournalHeader& header() const { return inputs_.front().journal.header; }
    std::size_t count_present() const { return present_; }
    bool has(std::uint32_t tile) const { return tiles_[tile] != nullptr; }

    /// Floats of one pixel of an image: 0 is the picture, i the header's layer i - 1.
    std::size_t channels(std::size_t image) const;
    std::int32_t strips() const;
    /// The pixels of a strip of an image; 0 where tiles are missing. Any thread may call this.
    std::vector<float> read_strip(std::size_t image, std::int32_t strip) const;
    /// Calls use(strip, pixels) for all strips of an image, on several threads, with a bounded number in
    /// memory. `use` may throw.
    void for_each_strip(std::size_t image, int threads,
                        const std::function<void(std::int32_t, std::span<const float>)>& use) const;
    /// The whole picture in memory.
    Image image() const;

  private:
    void release() const;
    const std::vector<JournalInput>& inputs_;
    std::vector<const JournalTile*> tiles_;  // by number; null if missing
    std::size_t present_ = 0;
};

}  // namespace glint::cli
