// SPDX-License-Identifier: Apache-2.0
// PPM, raw (P6): https://netpbm.sourceforge.net/doc/ppm.html
#include <fmt/format.h>

#include <algorithm>

#include "base/parallel_for.h"
#include "image/encoders.h"
#include "image/quantize.h"

namespace glint {

std::vector<std::uint8_t> encode_ppm(const Image& image, const EncodeOptions& options) {
    const std::string header =
        fmt::format("P6\n{} {}\n{}\n", image.width, image.height, options.bits == 8 ? 255 : 65535);
    const std::size_t samples = std::size_t{3} * image.width;
    const std::size_t row_bytes = samples * (options.bits / 8);
    std::vector<std::uint8_t> bytes;
    bytes.resize(header.size() + row_bytes * image.height);
    std::copy(header.begin(), header.end(), bytes.begin());
    parallel_for(image.height, options.threads, [&](std::size_t y) {
        quantize_row(&image.rgb[y * samples], samples, options.bits, options.transfer,
                     &bytes[header.size() + y * row_bytes]);
    });
    return bytes;
}

}  // namespace glint
