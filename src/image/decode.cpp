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

template <class T> T unless_failed(Result<T> result) {
    if (!result) throw StatusError(std::move(result));
    return *std::move(result);
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
        if (begins_with(bytes, magic)) return unless_failed(decode_ppm(bytes, options));
    }
    throw Undecodable(bytes.empty() ? "an empty file" : "no PNG, PPM, PGM, OpenEXR or JPEG file");
}

}  // namespace

void check_size(std::int64_t width, std::int64_t height, const DecodeOptions& options) {
    if (Status fault = size_fault(width, height, {options}); !fault.ok()) throw StatusError(std::move(fault));
}

void check_memory(std::uint64_t needed, std::uint64_t pixels, const DecodeOptions& options) {
    if (Status fault = decoding_fault(needed, pixels, options); !fault.ok())
        throw StatusError(std::move(fault));
}

StoredPicture make_picture(std::size_t width, std::size_t height, std::uint32_t most, std::uint64_t extra,
                           const DecoderOptions& options) {
    return unless_failed(new_picture(width, height, most, extra, options));
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
