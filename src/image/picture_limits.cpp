// SPDX-License-Identifier: Apache-2.0
// The sizes and the memory that a decoder may have, and its errors.
#include <fmt/format.h>

#include <utility>

#include "base/memory_limit.h"
#include "base/status.h"
#include "image/decoders.h"

namespace glint {
namespace {

// By default; the same for a picture of bytes as for one of floats.
constexpr std::uint64_t k_decoding = std::uint64_t{1} << 29, k_decoding_each = 24;

}  // namespace

Status undecodable(std::string message) { return failure(ErrorCode::parse, std::move(message)); }

Status size_fault(std::int64_t width, std::int64_t height, const DecoderOptions& options) {
    if (width < 1 || height < 1 || width > options.max_side || height > options.max_side) {
        return undecodable(fmt::format("a picture of {} x {} pixels; those read have 1 to {} a side", width,
                                       height, options.max_side));
    }
    if (width * height > options.max_pixels) {
        return undecodable(fmt::format("a picture of {} x {} pixels; those read have at most {} in all",
                                       width, height, options.max_pixels));
    }
    return {};
}

std::uint64_t memory_limit(std::uint64_t pixels, const DecodeOptions& options) {
    return options.max_memory > 0 ? options.max_memory : k_decoding + k_decoding_each * pixels;
}

Status decoding_fault(std::uint64_t needed, std::uint64_t pixels, const DecodeOptions& options) {
    return memory_fault(needed, memory_limit(pixels, options), "decoding the picture");
}

Result<StoredPicture> new_picture(std::size_t width, std::size_t height, std::uint32_t most,
                                  std::uint64_t extra, const DecoderOptions& options) {
    const bool is_float = options.as_floats || most == 0;
    const std::uint64_t pixels = std::uint64_t{width} * height, each = is_float ? 12 : most < 256 ? 3 : 6;
    if (Status fault = decoding_fault(each * pixels + extra, pixels, options); !fault.ok()) return fault;
    StoredPicture picture{static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), most, {}};
    const std::size_t count = 3 * width * height;
    if (is_float)
        picture.rgb = std::vector<float>(count);
    else if (most < 256)
        picture.rgb = std::vector<std::uint8_t>(count);
    else
        picture.rgb = std::vector<std::uint16_t>(count);
    return picture;
}

}  // namespace glint
