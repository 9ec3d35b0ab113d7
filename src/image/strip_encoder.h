// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures that are encoded strip by strip, so that the whole picture need not be in memory. The bytes are
// those of encode().
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "glint/image.h"
#include "glint/layers.h"
#include "glint/tiles.h"

namespace glint {

/// Rows of a strip; the last one has what is left. PNG compresses each strip separately, so the bytes of a
/// file depend on this number. High enough that a strip's own Huffman tables and empty history cost little,
/// low enough to use several threads for a small picture.
inline constexpr std::int32_t k_strip_rows = k_tile_side;

inline std::int32_t count_strips(std::int32_t height) { return (height - 1) / k_strip_rows + 1; }

/// The destination of a file's bytes. Its functions may throw.
class ByteFile {
  public:
    virtual ~ByteFile() = default;
    virtual void write(std::span<const std::uint8_t> bytes) = 0;
    virtual std::uint64_t position() const = 0;
    /// The next byte is written to this place, which may be before bytes that were written.
    virtual void seek(std::uint64_t position) = 0;
};

/// A strip between encode() and append().
struct EncodedStrip {
    std::vector<std::uint8_t> bytes;
    std::vector<float> values;  ///< OpenEXR: its library encodes while it writes
    std::uint32_t adler = 1;    ///< PNG: the checksum of `length` bytes before compression
    std::size_t length = 0;
};

/// Encodes one picture. All functions may throw what their library or the ByteFile throws.
class StripEncoder {
  public:
    virtual ~StripEncoder() = default;
    /// values: the strip's linear RGB, row by row; with alpha, that of with_alpha(). Any number of threads
    /// may call this at the same time.
    virtual EncodedStrip encode(std::int32_t strip, std::span<const float> values) const = 0;
    /// Writes the strips, in order; one call at a time.
    virtual void append(EncodedStrip strip) = 0;
    /// Writes what follows the last strip.
    virtual void finish() = 0;
};

/// The reason why a picture of this size cannot be encoded so, or an empty string. "JPEG has 8 bits a
/// channel"
std::string encoding_fault(std::int32_t width, std::int32_t height, const EncodeOptions& options, bool alpha);

/// The encoder of a picture without encoding_fault(). The file must outlive it.
std::unique_ptr<StripEncoder> make_strip_encoder(std::int32_t width, std::int32_t height,
                                                 const EncodeOptions& options, ByteFile& file,
                                                 bool alpha = false);

/// r, g, b and alpha of each pixel, from r, g and b and from alpha.
std::vector<float> with_alpha(std::span<const float> rgb, std::span<const float> alpha);

/// Encodes an OpenEXR file of several parts: the picture (part 0) and layers, as encode_layers() does.
class PartsEncoder {
  public:
    virtual ~PartsEncoder() = default;
    /// Writes rows of a part. Parts are written in order, and the rows of each in order.
    virtual void append(std::size_t part, std::int32_t first_row, std::int32_t rows, const float* values) = 0;
    virtual void finish() = 0;
};

/// As make_strip_encoder().
std::unique_ptr<PartsEncoder> make_parts_encoder(std::int32_t width, std::int32_t height,
                                                 std::span<const Layer> layers, ByteFile& file,
                                                 bool alpha = false);

}  // namespace glint
