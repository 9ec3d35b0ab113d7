// SPDX-License-Identifier: Apache-2.0
// Selects the decoder by the file's first bytes.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/fp_environment.h"
#include "base/status.h"
#include "image/decoders.h"

namespace glint {
namespace {

bool begins_with(ByteSpan bytes, std::string_view magic) {
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(),
                      [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

[[noreturn, maybe_unused]] void refuse(std::string_view format) {
    throw Undecodable(fmt::format("this build reads no {}", format));
}

DecodedImage decode_any(ByteSpan bytes, const DecodeOptions& options) {
    if (begins_with(bytes, "\x89PNG")) {
#if defined(GLINT_WITH_PNG)
        return decode_png(bytes, options);
#else
        refuse("PNG");
#endif
    }
    if (begins_with(bytes, "\x76\x2f\x31\x01")) {
#if defined(GLINT_WITH_EXR)
        return decode_exr(bytes, options);
#else
        refuse("OpenEXR");
#endif
    }
    if (begins_with(bytes, "\xff\xd8\xff")) {
#if defined(GLINT_WITH_JPEG)
        return decode_jpeg(bytes, options);
#else
        refuse("JPEG");
#endif
    }
    for (const std::string_view magic : {"P2", "P3", "P5", "P6"}) {
        if (begins_with(bytes, magic)) return decode_ppm(bytes, options);
    }
    throw Undecodable(bytes.empty() ? "an empty file" : "no PNG, PPM, PGM, OpenEXR or JPEG file");
}

}  // namespace

void check_size(std::int64_t width, std::int64_t height, const DecodeOptions& options) {
    if (width < 1 || height < 1 || width > k_max_size || height > k_max_size) {
        throw Undecodable(fmt::format("a picture of {} x {} pixels; those read have 1 to {} a side", width,
                                      height, k_max_size));
    }
    if (width * height > options.max_pixels) {
        throw Undecodable(fmt::format("a picture of {} x {} pixels; those read have at most {} in all", width,
                                      height, options.max_pixels));
    }
}

Result<DecodedImage> decode(std::span<const std::uint8_t> bytes, const DecodeOptions& options) {
    auto result = result_of([&]() -> Result<DecodedImage> {
        const DefaultFpEnvironment environment;
        return decode_any(bytes, options);
    });
    // The libraries throw where a file breaks its format.
    if (result.code == ErrorCode::internal) result.code = ErrorCode::parse;
    return result;
}

}  // namespace glint
