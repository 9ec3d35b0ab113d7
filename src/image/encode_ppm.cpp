// SPDX-License-Identifier: Apache-2.0
// PPM, raw (P6): https://netpbm.sourceforge.net/doc/ppm.html
#include <fmt/format.h>

#include "image/quantizing_encoder.h"

namespace glint {
namespace {

class PpmEncoder : public QuantizingEncoder {
  public:
    PpmEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file)
        : QuantizingEncoder(width, options, file) {
        const std::string header =
            fmt::format("P6\n{} {}\n{}\n", width, height, options.bits == 8 ? 255 : 65535);
        file.write({reinterpret_cast<const std::uint8_t*>(header.data()), header.size()});
    }
};

}  // namespace

std::unique_ptr<StripEncoder> make_ppm_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file) {
    return std::make_unique<PpmEncoder>(width, height, options, file);
}

}  // namespace glint
