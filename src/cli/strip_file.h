// SPDX-License-Identifier: Apache-2.0
#pragma once
// A picture that is written strip by strip.
#include <map>
#include <memory>
#include <mutex>
#include <span>

#include "cli/output_file.h"
#include "image/strip_encoder.h"

namespace glint::cli {

class StripFile {
  public:
    /// output: the destination, which must outlive this. Throws Failure.
    StripFile(const OutputFile& output, const EncodeOptions& encoding, std::int32_t width,
              std::int32_t height, bool alpha = false);

    /// Encodes a strip, given as linear RGB (with alpha: RGBA), and writes what is next in the file. Each
    /// strip once, in any order, from any thread. Throws Failure.
    void put(std::int32_t strip, std::span<const float> values);

    /// After all strips. durable: as OutputFile::write(). Throws Failure.
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

}  // namespace glint::cli
