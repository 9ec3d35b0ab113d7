// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a fuzzer does with a picture file: read it and look at the answer.
#include <cmath>
#include <span>
#include <string>

#include "glint/image.h"

namespace glint::test {

/// Decodes the bytes, as a picture of few pixels; an empty string, or what is wrong with the answer.
inline std::string fuzz_decode(std::span<const std::uint8_t> bytes) {
    DecodeOptions options;
    options.max_pixels = 1 << 16;
    const DecodeResult result = decode(bytes, options);
    if (result.image.has_value() != result.error.empty())
        return "a picture and an error, or neither: " + result.error;
    if (!result.image) return {};
    const Image& image = *result.image;
    if (std::int64_t{image.width} * image.height > options.max_pixels) return "a picture that is too large";
    for (const float value : image.rgb) {
        if (!std::isfinite(value) && result.note.find("NaN") == std::string::npos)
            return "a number that is not finite, and no word of it";
    }
    // What was read is a picture that can be written, and of 8 bits the same bytes come back.
    const EncodeResult written = encode(image, {FileFormat::ppm});
    if (!written.error.empty()) return "not written: " + written.error;
    const DecodeResult again = decode(written.bytes, options);
    if (!again.image) return "not read again: " + again.error;
    return encode(*again.image, {FileFormat::ppm}).bytes == written.bytes ? std::string()
                                                                          : "other bytes came back";
}

}  // namespace glint::test
