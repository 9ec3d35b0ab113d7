// SPDX-License-Identifier: Apache-2.0
// PPM, raw (P6): https://netpbm.sourceforge.net/doc/ppm.html
#include <fmt/format.h>

#include "image/encoders.h"
#include "image/quantize.h"

namespace glint {
namespace {

class PpmEncoder : public StripEncoder {
  public:
    PpmEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file)
        : samples_(std::size_t{3} * width), options_(options), file_(file) {
        const std::string header =
            fmt::format("P6\n{} {}\n{}\n", width, height, options.bits == 8 ? 255 : 65535);
        file_.write({reinterpret_cast<const std::uint8_t*>(header.data()), header.size()});
    }

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

  private:
    const std::size_t samples_;
    const EncodeOptions options_;
    ByteFile& file_;
};

}  // namespace

std::unique_ptr<StripEncoder> make_ppm_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file) {
    return std::make_unique<PpmEncoder>(width, height, options, file);
}

}  // namespace glint
