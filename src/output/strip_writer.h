// SPDX-License-Identifier: Apache-2.0
#pragma once
// A picture that is written strip by strip.
#include <map>
#include <memory>
#include <mutex>
#include <span>

#include "output/file_in_progress.h"

namespace glint {

class StripWriter {
  public:
    /// Throws if there is an encoding_fault().
    StripWriter(std::unique_ptr<FileInProgress> file, const EncodeOptions& encoding, std::int32_t width,
                std::int32_t height, bool alpha = false);

    /// Encodes a strip, given as linear RGB (with alpha: RGBA), and writes what is next in the file. Each
    /// strip once, in any order, from any thread. Throws if the file cannot be written.
    void put(std::int32_t strip, std::span<const float> values);

    /// After all strips. durable: as FileInProgress::commit(). Throws.
    void finish(bool durable);

  private:
    const std::unique_ptr<FileInProgress> file_;
    const std::unique_ptr<StripEncoder> encoder_;
    std::mutex mutex_;
    std::map<std::int32_t, EncodedStrip> waiting_;  // for those before them
    std::int32_t next_ = 0;
};

/// The pixels of a strip of `picture`.
Crop strip_area(const Crop& picture, std::int32_t strip);

}  // namespace glint
