// SPDX-License-Identifier: Apache-2.0
#pragma once
// A memory stream for OpenEXR.
#include <ImfIO.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace glint::test {

class MemoryInput : public Imf::IStream {
  public:
    explicit MemoryInput(const std::vector<std::uint8_t>& bytes) : Imf::IStream("memory"), bytes_(bytes) {}
    bool read(char out[], int count) override {
        if (position_ + static_cast<std::size_t>(count) > bytes_.size())
            throw std::runtime_error("end of file");
        std::memcpy(out, bytes_.data() + position_, static_cast<std::size_t>(count));
        position_ += static_cast<std::size_t>(count);
        return position_ < bytes_.size();
    }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override { position_ = position; }

  private:
    const std::vector<std::uint8_t>& bytes_;
    std::size_t position_ = 0;
};

}  // namespace glint::test
