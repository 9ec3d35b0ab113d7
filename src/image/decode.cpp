// SPDX-License-Identifier: Apache-2.0
// Selects the decoder by the file's first bytes.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/fp_environment.h"
#include "base/memory_limit.h"
#include "base/status.h"
#include "image/decoders.h"

namespace glint {
namespace {

// By default; the same for a picture of bytes as for one of floats.
constexpr std::uint64_t k_decoding = std::uint64_t{1} << 29, k_decoding_each = 24;

bool begins_with(ByteSpan bytes, std::string_view magic) {
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(),
                      [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

[[noreturn, maybe_unused]] void refuse(std::string_view format) {
    throw Undecodable(fmt::format("this build reads no {}", format));
}

DecodedPicture decode_any(ByteSpan bytes, const DecoderOptions& options) {
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

std::uint64_t memory_limit(std::uint64_t pixels, const DecodeOptions& options) {
    return options.max_memory > 0 ? options.max_memory : k_decoding + k_decoding_each * pixels;
}

void check_memory(std::uint64_t needed, std::uint64_t pixels, const DecodeOptions& options) {
    Status fault = memory_fault(needed, memory_limit(pixels, options), "decoding the picture");
    if (!fault.ok()) throw StatusError(std::move(fault));
}

StoredPicture make_picture(std::size_t width, std::size_t height, std::uint32_t most, std::uint64_t extra,
                           const DecoderOptions& options) {
    const bool is_float = options.as_floats || most == 0;
    const std::uint64_t pixels = std::uint64_t{width} * height, each = is_float ? 12 : most < 256 ? 3 : 6;
    check_memory(each * pixels + extra, pixels, options);
    StoredPicture picture{static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), most, {}};
    if (is_float)
        picture.rgb = std::vector<float>(3 * pixels);
    else if (most < 256)
        picture.rgb = std::vector<std::uint8_t>(3 * pixels);
    else
        picture.rgb = std::vector<std::uint16_t>(3 * pixels);
    return picture;
}

Result<DecodedPicture> decode_stored(ByteSpan bytes, const DecoderOptions& options) {
    auto result = result_of([&]() -> Result<DecodedPicture> {
        const DefaultFpEnvironment environment;
        return decode_any(bytes, options);
    });
    // The libraries throw where a file breaks its format. OpenEXR gives only the text of an exception.
    if (result.code == ErrorCode::internal && result.message.find("bad_alloc") != std::string::npos)
        return failure(ErrorCode::out_of_memory, "out of memory");
    if (result.code == ErrorCode::internal) result.code = ErrorCode::parse;
    return result;
}

Result<DecodedImage> decode(std::span<const std::uint8_t> bytes, const DecodeOptions& options) {
    Result<DecodedPicture> decoded = decode_stored(bytes, {options, true});
    if (!decoded) return Status(decoded);
    StoredPicture& picture = decoded->picture;
    return DecodedImage{{picture.width, picture.height, std::get<std::vector<float>>(std::move(picture.rgb))},
                        decoded->bits,
                        std::move(decoded->note)};
}

}  // namespace glint
