// SPDX-License-Identifier: Apache-2.0
// TGA, uncompressed, 8 bits, with rows from the top: "Truevision TGA File Format Specification", version 2.0.
#include <array>
#include <utility>

#include "image/quantizing_encoder.h"

namespace glint {
namespace {

class TgaEncoder : public QuantizingEncoder {
  public:
    TgaEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file)
        : QuantizingEncoder(width, with_bytes(options), file) {
        const auto low = [](std::int32_t n) { return static_cast<std::uint8_t>(n & 0xff); };
        const auto high = [](std::int32_t n) { return static_cast<std::uint8_t>(n >> 8 & 0xff); };
        std::array<std::uint8_t, 18> header{};
        header[2] = 2;  // true color, not compressed
        header[12] = low(width);
        header[13] = high(width);
        header[14] = low(height);
        header[15] = high(height);
        header[16] = 24;    // bits of a pixel
        header[17] = 0x20;  // the first row is the top one
        file.write(header);
    }

    // Pixels are blue, green and red.
    EncodedStrip encode(std::int32_t strip, std::span<const float> values) const override {
        EncodedStrip encoded = QuantizingEncoder::encode(strip, values);
        for (std::size_t i = 0; i + 2 < encoded.bytes.size(); i += 3)
            std::swap(encoded.bytes[i], encoded.bytes[i + 2]);
        return encoded;
    }

  private:
    static EncodeOptions with_bytes(EncodeOptions options) {
        options.bits = 8;
        return options;
    }
};

}  // namespace

std::unique_ptr<StripEncoder> make_tga_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file) {
    return std::make_unique<TgaEncoder>(width, height, options, file);
}

}  // namespace glint
