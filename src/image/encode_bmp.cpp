// SPDX-License-Identifier: Apache-2.0
// BMP, uncompressed, 24 bits, with rows from the bottom: BITMAPINFOHEADER of the Windows documentation. The
// other order of rows is possible, but few programs expect it.
#include <array>
#include <stdexcept>
#include <utility>

#include "image/quantizing_encoder.h"

namespace glint {
namespace {

constexpr std::size_t k_header_bytes = 54;

class BmpEncoder : public QuantizingEncoder {
  public:
    BmpEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file)
        : QuantizingEncoder(width, options, file),
          samples_(std::size_t{3} * static_cast<std::size_t>(width)),
          row_bytes_((samples_ + 3) / 4 * 4),
          next_(k_header_bytes + row_bytes_ * static_cast<std::size_t>(height)) {
        if (next_ >> 32 != 0) throw std::runtime_error("BMP has at most 4 GiB");
        std::array<std::uint8_t, k_header_bytes> header{'B', 'M'};
        const auto put = [&](std::size_t at, std::uint64_t value) {
            for (std::size_t i = 0; i < 4; ++i) header[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
        };
        put(2, next_);  // bytes of the file
        put(10, k_header_bytes);
        put(14, 40);  // bytes of what follows
        put(18, static_cast<std::uint64_t>(width));
        put(22, static_cast<std::uint64_t>(height));
        header[26] = 1;   // plane
        header[28] = 24;  // bits of a pixel
        put(34, next_ - k_header_bytes);
        file.write(header);
    }

    // Pixels are blue, green and red; a row has a multiple of four bytes.
    EncodedStrip encode(std::int32_t strip, std::span<const float> values) const override {
        const EncodedStrip from_top = QuantizingEncoder::encode(strip, values);
        const std::size_t rows = from_top.bytes.size() / samples_;
        EncodedStrip encoded;
        encoded.bytes.resize(rows * row_bytes_);
        for (std::size_t row = 0; row < rows; ++row) {
            const std::uint8_t* from = &from_top.bytes[row * samples_];
            std::uint8_t* to = &encoded.bytes[(rows - 1 - row) * row_bytes_];
            for (std::size_t i = 0; i < samples_; i += 3) {
                to[i] = from[i + 2];
                to[i + 1] = from[i + 1];
                to[i + 2] = from[i];
            }
        }
        return encoded;
    }

    void append(EncodedStrip strip) override {
        next_ -= strip.bytes.size();
        file_.seek(next_);
        file_.write(strip.bytes);
    }

  private:
    const std::size_t samples_, row_bytes_;
    std::uint64_t next_;  // where the strips below begin
};

}  // namespace

std::unique_ptr<StripEncoder> make_bmp_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file) {
    return std::make_unique<BmpEncoder>(width, height, options, file);
}

}  // namespace glint
