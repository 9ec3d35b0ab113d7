// SPDX-License-Identifier: Apache-2.0
#pragma once
// Formats of integers without alpha, which are made row by row: PPM, TGA, BMP and JPEG.
#include "image/encoders.h"
#include "image/quantize.h"

namespace glint {

class QuantizingEncoder : public StripEncoder {
  public:
    EncodedStrip encode(std::int32_t, std::span<const float> values) const override {
        EncodedStrip strip;
        const std::size_t sample_bytes = options_.bits / 8;
        strip.bytes.resize(values.size() * sample_bytes);
        for (std::size_t first = 0; first < values.size(); first += samples_) {
            quantize_row(&values[first], samples_, options_.bits, options_.rule(),
                         &strip.bytes[first * sample_bytes]);
        }
        return strip;
    }

    void append(EncodedStrip strip) override { file_.write(strip.bytes); }
    void finish() override {}

  protected:
    /// The class that inherits writes the header.
    QuantizingEncoder(std::int32_t width, const EncodeOptions& options, ByteFile& file)
        : options_(options), file_(file), samples_(std::size_t{3} * static_cast<std::size_t>(width)) {}

    const EncodeOptions options_;
    ByteFile& file_;

  private:
    const std::size_t samples_;  // of a row
};

}  // namespace glint
