// SPDX-License-Identifier: Apache-2.0
#pragma once
// One function per file format, for bytes that begin as that format does. They throw exceptions of their
// libraries, bad_alloc, and Undecodable; decode() catches them.
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "glint/conventions.h"
#include "glint/image.h"

namespace glint {

using ByteSpan = std::span<const std::uint8_t>;

/// An error of a file, with the message that decode() returns.
class Undecodable : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws Undecodable if the picture's size is invalid or too large.
void check_size(std::int64_t width, std::int64_t height, const DecodeOptions& options);

DecodedImage decode_png(ByteSpan bytes, const DecodeOptions& options);
DecodedImage decode_ppm(ByteSpan bytes, const DecodeOptions& options);
DecodedImage decode_exr(ByteSpan bytes, const DecodeOptions& options);
DecodedImage decode_jpeg(ByteSpan bytes, const DecodeOptions& options);

}  // namespace glint
