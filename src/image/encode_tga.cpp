// SPDX-License-Identifier: Apache-2.0
// TGA, uncompressed, 8 bits, with rows from the top: "Truevision TGA File Format Specification", version 2.0.
#include <array>
#include <utility>

#include "image/encoders.h"
#include "image/quantize.h"

namespace glint {
namespace {

class TgaEncoder : public StripEncoder {
  public:
    TgaEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file)
        : samples_(std::size_t{3} * static_cast<std::size_t>(width)), options_(options), file_(file) {
        const auto low = [](std::int32_t n) { return static_cast<std::uint8_t>(n & 0xff); };
        const auto high = [](std::int32_t n) { return static_cast<std::uint8_t>(n >> 8 & 0xff); };
        std::array<std::uint8_t, 18> header{};
        header[2] = 2;  // true colour, not compressed
        header[12] = low(width);
        header[13] = high(width);
        header[14] = low(height);
        header[15] = high(height);
        header[16] = 24;    // bits of a pixel
        header[17] = 0x20;  // the first row is the top one
        file_.write(header);
    }

    // Pixels are blue, green and red.
    EncodedStrip encode(std::int32_t, std::span<const float> values) const override {
        EncodedStrip strip;
        strip.bytes.resize(values.size());
        for (std::size_t first = 0; first < values.size(); first += samples_)
            quantize_row(&values[first], samples_, 8, options_.rule(), &strip.bytes[first]);
        for (std::size_t i = 0; i + 2 < strip.bytes.size(); i += 3)
            std::swap(strip.bytes[i], strip.bytes[i + 2]);
        return strip;
    }

    void append(EncodedStrip strip) override { file_.write(strip.bytes); }
    void finish() override {}

  private:
    const std::size_t samples_;
    const EncodeOptions options_;
    ByteFile& file_;
};

}  // namespace

std::unique_ptr<StripEncoder> make_tga_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file) {
    return std::make_unique<TgaEncoder>(width, height, options, file);
}

}  // namespace glint
