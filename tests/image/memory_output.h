// SPDX-License-Identifier: Apache-2.0
#pragma once
// OpenEXR files that its library writes to memory.
#include <ImfIO.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace glint::test {

class MemoryOutput : public Imf::OStream {
  public:
    MemoryOutput() : Imf::OStream("memory") {}
    void write(const char data[], int count) override {
        bytes.resize(std::max(bytes.size(), at + static_cast<std::size_t>(count)));
        std::memcpy(bytes.data() + at, data, static_cast<std::size_t>(count));
        at += static_cast<std::size_t>(count);
    }
    uint64_t tellp() override { return at; }
    void seekp(uint64_t position) override { at = position; }
    std::vector<std::uint8_t> bytes;
    std::size_t at = 0;
};

}  // namespace glint::test
