// SPDX-License-Identifier: Apache-2.0
#pragma once
// One function per file format, for bytes that begin as that format does. They throw exceptions of their
// libraries, bad_alloc, StatusError and Undecodable; decode() catches them.
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "glint/conventions.h"
#include "glint/image.h"
#include "image/stored_picture.h"

namespace glint {

using ByteSpan = std::span<const std::uint8_t>;

/// An error of a file, with the message that decode() returns.
class Undecodable : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// As DecodedImage.
struct DecodedPicture {
    StoredPicture picture;
    int bits = 8;
    std::string note;
};

struct DecoderOptions : DecodeOptions {
    bool as_floats = false;               ///< whole numbers become floats
    std::uint32_t max_side = k_max_size;  ///< the greatest width and height
};

/// As decode(), with the numbers of the file. Never throws.
Result<DecodedPicture> decode_stored(ByteSpan bytes, const DecoderOptions& options);

/// An error of a file, for decoders that do not throw.
Status undecodable(std::string message);

/// A failure if the picture's size is invalid or too large; check_size() throws it as a StatusError.
Status size_fault(std::int64_t width, std::int64_t height, const DecoderOptions& options);
void check_size(std::int64_t width, std::int64_t height, const DecodeOptions& options);

/// The limit of options.max_memory for a picture of this size, and a failure if more bytes are needed, which
/// check_memory() throws as a StatusError.
std::uint64_t memory_limit(std::uint64_t pixels, const DecodeOptions& options);
Status decoding_fault(std::uint64_t needed, std::uint64_t pixels, const DecodeOptions& options);
void check_memory(std::uint64_t needed, std::uint64_t pixels, const DecodeOptions& options);

/// Black; most: the largest whole number of a channel, 0 for floats. A failure if it and `extra` bytes, those
/// that the decoder needs, are more than options.max_memory; make_picture() throws it as a StatusError.
Result<StoredPicture> new_picture(std::size_t width, std::size_t height, std::uint32_t most,
                                  std::uint64_t extra, const DecoderOptions& options);
StoredPicture make_picture(std::size_t width, std::size_t height, std::uint32_t most, std::uint64_t extra,
                           const DecoderOptions& options);

DecodedPicture decode_png(ByteSpan bytes, const DecoderOptions& options);
/// Does not throw: the browser build has it, too.
Result<DecodedPicture> decode_ppm(ByteSpan bytes, const DecoderOptions& options);
DecodedPicture decode_exr(ByteSpan bytes, const DecoderOptions& options);
DecodedPicture decode_jpeg(ByteSpan bytes, const DecoderOptions& options);

}  // namespace glint
