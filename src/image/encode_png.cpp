// SPDX-License-Identifier: Apache-2.0
// PNG (https://www.w3.org/TR/png-3/), RGB or RGBA with 8 or 16 bits. Strips are filtered and compressed
// separately, each to complete bytes of one deflate stream. So the file does not depend on the number of
// threads.
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "image/encoders.h"
#include "image/memory_file.h"
#include "image/quantize.h"

namespace glint {
namespace {

using Bytes = std::vector<std::uint8_t>;

void put32(std::uint8_t* out, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) out[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

// Bytes of a chunk before its data (length and type) and after it (checksum).
constexpr std::size_t k_chunk_head = 8, k_chunk_tail = 4;

// Writes the head and the tail of a chunk around its data.
void seal_chunk(Bytes& chunk, std::string_view type) {
    const std::size_t length = chunk.size() - k_chunk_head - k_chunk_tail;
    put32(chunk.data(), static_cast<std::uint32_t>(length));
    std::copy(type.begin(), type.end(), chunk.begin() + 4);
    const uLong crc = crc32_z(0, chunk.data() + 4, length + 4);
    put32(chunk.data() + k_chunk_head + length, static_cast<std::uint32_t>(crc));
}

void write_chunk(ByteFile& file, std::string_view type, const Bytes& data) {
    Bytes chunk(k_chunk_head + data.size() + k_chunk_tail);
    std::copy(data.begin(), data.end(), chunk.begin() + k_chunk_head);
    seal_chunk(chunk, type);
    file.write(chunk);
}

// PNG's alpha is straight: the color is that of the opaque part. Alpha itself is linear.
void quantize_straight(const float* rgba, std::size_t pixels, const EncodeOptions& options,
                       std::uint8_t* out) {
    const std::size_t bytes = options.bits / 8;
    for (std::size_t i = 0; i < pixels; ++i, rgba += 4, out += 4 * bytes) {
        const float alpha = rgba[3];
        float color[3] = {};
        for (int c = 0; c < 3 && alpha > 0; ++c) color[c] = rgba[c] / alpha;
        quantize_row(color, 3, options.bits, options.rule(), out);
        quantize_row(&alpha, 1, options.bits, ByteRule{}, out + 3 * bytes);
    }
}

// Filters rows with Sub: a pixel minus its left neighbour. On ray-traced pictures, this with
// runs alone (below) gives files as small as fast matching with any filter, and is faster; and strips do
// not depend on each other.
void filter_row(const std::uint8_t* row, std::size_t row_bytes, std::size_t pixel_bytes, std::uint8_t* out) {
    *out++ = 1;
    std::memcpy(out, row, pixel_bytes);
    for (std::size_t i = pixel_bytes; i < row_bytes; ++i)
        out[i] = static_cast<std::uint8_t>(row[i] - row[i - pixel_bytes]);
}

Bytes filter_rows(std::span<const float> rows, std::int32_t width, const EncodeOptions& options, bool alpha) {
    const std::size_t channels = alpha ? 4 : 3, samples = channels * static_cast<std::size_t>(width);
    const std::size_t pixel_bytes = options.bits == 8 ? channels : 2 * channels;
    const std::size_t row_bytes = pixel_bytes * width;
    Bytes row(row_bytes);
    Bytes filtered((row_bytes + 1) * (rows.size() / samples));
    std::uint8_t* out = filtered.data();
    for (std::size_t first = 0; first < rows.size(); first += samples) {
        if (alpha) {
            quantize_straight(&rows[first], static_cast<std::size_t>(width), options, row.data());
        } else {
            quantize_row(&rows[first], samples, options.bits, options.rule(), row.data());
        }
        filter_row(row.data(), row_bytes, pixel_bytes, out);
        out += row_bytes + 1;
    }
    return filtered;
}

// A zlib stream is a header, raw deflate blocks, and a checksum of all data. Every strip except the last ends
// with an empty stored block, which completes its last byte.
EncodedStrip compress_strip(const Bytes& data, bool is_first, bool is_last, int level = 1,
                            int strategy = Z_RLE) {
    z_stream z{};
    if (deflateInit2(&z, level, Z_DEFLATED, -15, 9, strategy) != Z_OK) throw std::bad_alloc();
    const std::size_t head = k_chunk_head + (is_first ? 2 : 0);
    EncodedStrip strip;
    Bytes& chunk = strip.bytes;
    chunk.resize(head + deflateBound(&z, static_cast<uLong>(data.size())) + 16);
    if (is_first) {
        chunk[k_chunk_head] = 0x78;
        chunk[k_chunk_head + 1] = 0x01;
    }
    z.next_in = const_cast<Bytef*>(data.data());
    z.avail_in = static_cast<uInt>(data.size());
    z.next_out = chunk.data() + head;
    z.avail_out = static_cast<uInt>(chunk.size() - head);
    const int code = deflate(&z, is_last ? Z_FINISH : Z_SYNC_FLUSH);
    const bool whole = z.avail_in == 0 && z.avail_out != 0 && code == (is_last ? Z_STREAM_END : Z_OK);
    chunk.resize(chunk.size() - z.avail_out);
    chunk.shrink_to_fit();  // all strips of a picture may be in memory together
    deflateEnd(&z);
    if (!whole) throw std::runtime_error("zlib did not compress");
    strip.length = data.size();
    strip.adler = static_cast<std::uint32_t>(adler32_z(1, data.data(), data.size()));
    return strip;
}

Bytes png_header(std::uint32_t width, std::uint32_t height, int bits, bool alpha) {
    Bytes header(13);  // width, height, bits, color type 2 (RGB) or 6 (RGBA), deflate, filters by row, not
                       // interlaced
    put32(header.data(), width);
    put32(header.data() + 4, height);
    header[8] = static_cast<std::uint8_t>(bits);
    header[9] = alpha ? 6 : 2;
    return header;
}

constexpr std::uint8_t k_signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

class PngEncoder : public StripEncoder {
  public:
    PngEncoder(std::int32_t width, std::int32_t height, const EncodeOptions& options, ByteFile& file,
               bool alpha)
        : width_(width), strips_(count_strips(height)), options_(options), alpha_(alpha), file_(file) {
        file_.write(k_signature);
        write_chunk(file_, "IHDR",
                    png_header(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                               options.bits, alpha));
        if (options.transfer == Transfer::srgb) write_chunk(file_, "sRGB", {0});
    }

    EncodedStrip encode(std::int32_t strip, std::span<const float> values) const override {
        const bool is_last = strip == strips_ - 1;
        EncodedStrip encoded =
            compress_strip(filter_rows(values, width_, options_, alpha_), strip == 0, is_last);
        if (is_last) return encoded;  // sealed when the checksum of all data is known
        encoded.bytes.resize(encoded.bytes.size() + k_chunk_tail);
        seal_chunk(encoded.bytes, "IDAT");
        return encoded;
    }

    void append(EncodedStrip strip) override {
        adler_ = adler32_combine(adler_, strip.adler, static_cast<z_off_t>(strip.length));
        Bytes& chunk = strip.bytes;
        if (++appended_ == strips_) {
            chunk.resize(chunk.size() + 4 + k_chunk_tail);
            put32(chunk.data() + chunk.size() - 4 - k_chunk_tail, static_cast<std::uint32_t>(adler_));
            seal_chunk(chunk, "IDAT");
        }
        file_.write(chunk);
    }

    void finish() override { write_chunk(file_, "IEND", {}); }

  private:
    const std::int32_t width_, strips_;
    const EncodeOptions options_;
    const bool alpha_;
    ByteFile& file_;
    uLong adler_ = 1;
    std::int32_t appended_ = 0;
};

}  // namespace

std::unique_ptr<StripEncoder> make_png_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file, bool alpha) {
    return std::make_unique<PngEncoder>(width, height, options, file, alpha);
}

std::vector<std::uint8_t> encode_png_words(std::uint32_t width, std::uint32_t height, bool alpha,
                                           std::span<const std::uint8_t> words) {
    const std::size_t channels = alpha ? 4 : 3, row_bytes = channels * width;
    if ((row_bytes + 1) * height > UINT32_MAX) throw std::runtime_error("zlib takes 4 GiB at most");
    Bytes filtered((row_bytes + 1) * height);
    for (std::size_t y = 0; y < height; ++y)
        filter_row(&words[row_bytes * y], row_bytes, channels, &filtered[(row_bytes + 1) * y]);
    // Photographs, unlike ray-traced pictures, are smaller with all that deflate does.
    EncodedStrip strip = compress_strip(filtered, true, true, 6, Z_DEFAULT_STRATEGY);
    Bytes& data = strip.bytes;
    data.resize(data.size() + 4 + k_chunk_tail);
    put32(data.data() + data.size() - 4 - k_chunk_tail, strip.adler);
    seal_chunk(data, "IDAT");
    Bytes bytes;
    MemoryFile file(bytes);
    file.write(k_signature);
    write_chunk(file, "IHDR", png_header(width, height, 8, alpha));
    write_chunk(file, "sRGB", {0});
    file.write(data);
    write_chunk(file, "IEND", {});
    return bytes;
}

}  // namespace glint
