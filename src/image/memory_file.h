// SPDX-License-Identifier: Apache-2.0
#pragma once
// A file in memory.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "image/strip_encoder.h"

namespace glint {

class MemoryFile : public ByteFile {
  public:
    explicit MemoryFile(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
    void write(std::span<const std::uint8_t> bytes) override {
        const std::size_t end = position_ + bytes.size();
        if (end > bytes_.size()) bytes_.resize(end);
        std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ = end;
    }
    std::uint64_t position() const override { return position_; }
    void seek(std::uint64_t position) override { position_ = position; }

  private:
    std::vector<std::uint8_t>& bytes_;
    std::size_t position_ = 0;
};

}  // namespace glint
