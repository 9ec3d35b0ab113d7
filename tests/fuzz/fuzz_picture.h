// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fuzzing of picture files: read them and check the result.
#include <cmath>
#include <span>
#include <string>

#include "glint/image.h"

namespace glint::test {

/// Decodes the bytes with a low limit of pixels. Returns an error message about the result, or an empty
/// string.
inline std::string fuzz_decode(std::span<const std::uint8_t> bytes) {
    DecodeOptions options;
    options.max_pixels = 1 << 16;
    const Result<DecodedImage> result = decode(bytes, options);
    if (result.has_value() != result.message.empty())
        return "a picture and an error, or neither: " + result.message;
    if (!result) return {};
    const Image& image = result->image;
    if (std::int64_t{image.width} * image.height > options.max_pixels) return "a picture that is too large";
    for (const float value : image.rgb) {
        if (!std::isfinite(value) && result->note.find("NaN") == std::string::npos)
            return "a number that is not finite, and no word of it";
    }
    // The decoded picture can be encoded; with 8 bits the bytes are equal.
    const Result<std::vector<std::uint8_t>> written = encode(image, {FileFormat::ppm});
    if (!written) return "not written: " + written.message;
    const Result<DecodedImage> again = decode(*written, options);
    if (!again) return "not read again: " + again.message;
    return encode(again->image, {FileFormat::ppm}).value() == *written ? std::string()
                                                                       : "other bytes came back";
}

}  // namespace glint::test
