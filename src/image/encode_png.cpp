// SPDX-License-Identifier: Apache-2.0
// PNG (https://www.w3.org/TR/png-3/), RGB with 8 or 16 bits. Strips of a fixed height are filtered and
// compressed separately, each to complete bytes of one deflate stream. So the file does not depend on the
// number of threads.
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "base/parallel_for.h"
#include "base/status.h"
#include "image/encoders.h"
#include "image/quantize.h"

namespace glint {
namespace {

using Bytes = std::vector<std::uint8_t>;

// High enough that a strip's own Huffman tables and empty history cost little, low enough to use several
// threads for a small picture.
constexpr std::int32_t k_strip_rows = 32;

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

void append_chunk(Bytes& out, std::string_view type, const Bytes& data) {
    Bytes chunk(k_chunk_head);
    chunk.insert(chunk.end(), data.begin(), data.end());
    chunk.resize(chunk.size() + k_chunk_tail);
    seal_chunk(chunk, type);
    out.insert(out.end(), chunk.begin(), chunk.end());
}

struct Strip {
    Bytes chunk;  // a complete IDAT chunk
    uLong adler = 1;
    std::size_t length = 0;  // before compression
    Status status;
};

// Filters rows [first, last) with Sub: a pixel minus its left neighbour. On ray-traced pictures, this with
// runs alone (below) gives files as small as fast matching with any filter, and is faster; and strips do
// not depend on each other.
Bytes filter_rows(const Image& image, const EncodeOptions& options, std::int32_t first, std::int32_t last) {
    const std::size_t samples = std::size_t{3} * image.width;
    const std::size_t pixel_bytes = options.bits == 8 ? 3 : 6;
    const std::size_t row_bytes = pixel_bytes * image.width;
    Bytes row(row_bytes);
    Bytes filtered((row_bytes + 1) * (last - first));
    std::uint8_t* out = filtered.data();
    for (std::int32_t y = first; y < last; ++y) {
        quantize_row(&image.rgb[y * samples], samples, options.bits, options.transfer, row.data());
        *out++ = 1;
        std::memcpy(out, row.data(), pixel_bytes);
        for (std::size_t i = pixel_bytes; i < row_bytes; ++i) {
            out[i] = static_cast<std::uint8_t>(row[i] - row[i - pixel_bytes]);
        }
        out += row_bytes;
    }
    return filtered;
}

// A zlib stream is a header, raw deflate blocks, and a checksum of all data. Every strip except the last ends
// with an empty stored block, which completes its last byte.
void compress_strip(const Bytes& data, bool is_first, bool is_last, Strip& strip) {
    z_stream z{};
    if (deflateInit2(&z, 1, Z_DEFLATED, -15, 9, Z_RLE) != Z_OK) throw std::bad_alloc();
    const std::size_t head = k_chunk_head + (is_first ? 2 : 0);
    strip.chunk.resize(head + deflateBound(&z, data.size()) + 16);
    if (is_first) {
        strip.chunk[k_chunk_head] = 0x78;
        strip.chunk[k_chunk_head + 1] = 0x01;
    }
    z.next_in = const_cast<Bytef*>(data.data());
    z.avail_in = static_cast<uInt>(data.size());
    z.next_out = strip.chunk.data() + head;
    z.avail_out = static_cast<uInt>(strip.chunk.size() - head);
    const int code = deflate(&z, is_last ? Z_FINISH : Z_SYNC_FLUSH);
    const bool whole = z.avail_in == 0 && z.avail_out != 0 && code == (is_last ? Z_STREAM_END : Z_OK);
    strip.chunk.resize(strip.chunk.size() - z.avail_out);
    strip.chunk.shrink_to_fit();  // all strips of a large picture are in memory together
    deflateEnd(&z);
    if (!whole) throw std::runtime_error("zlib did not compress");
    strip.length = data.size();
    strip.adler = adler32_z(1, data.data(), data.size());
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, const EncodeOptions& options) {
    const std::int32_t count = (image.height + k_strip_rows - 1) / k_strip_rows;
    std::vector<Strip> strips(count);
    parallel_for(count, options.threads, [&](std::size_t i) {
        strips[i].status = status_of([&] {
            const auto first = static_cast<std::int32_t>(i) * k_strip_rows;
            const auto last = std::min(first + k_strip_rows, image.height);
            const bool is_last = last == image.height;
            compress_strip(filter_rows(image, options, first, last), i == 0, is_last, strips[i]);
            if (is_last) return;  // sealed below, when the checksum of all data is known
            strips[i].chunk.resize(strips[i].chunk.size() + k_chunk_tail);
            seal_chunk(strips[i].chunk, "IDAT");
        });
    });
    uLong adler = 1;
    std::size_t total = 0;
    for (const Strip& strip : strips) {
        if (!strip.status.ok()) throw StatusError(strip.status);
        adler = adler32_combine(adler, strip.adler, static_cast<z_off_t>(strip.length));
        total += strip.chunk.size();
    }
    Bytes& last = strips.back().chunk;
    last.resize(last.size() + 4 + k_chunk_tail);
    put32(last.data() + last.size() - 4 - k_chunk_tail, static_cast<std::uint32_t>(adler));
    seal_chunk(last, "IDAT");

    Bytes bytes;
    bytes.reserve(total + 100);
    constexpr std::uint8_t signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    bytes.assign(std::begin(signature), std::end(signature));
    Bytes header(13);  // width, height, bits, colour type 2 (RGB), deflate, filters by row, not interlaced
    put32(header.data(), static_cast<std::uint32_t>(image.width));
    put32(header.data() + 4, static_cast<std::uint32_t>(image.height));
    header[8] = static_cast<std::uint8_t>(options.bits);
    header[9] = 2;
    append_chunk(bytes, "IHDR", header);
    if (options.transfer == Transfer::srgb) append_chunk(bytes, "sRGB", {0});
    for (Strip& strip : strips) {
        bytes.insert(bytes.end(), strip.chunk.begin(), strip.chunk.end());
        Bytes().swap(strip.chunk);
    }
    append_chunk(bytes, "IEND", {});
    return bytes;
}

}  // namespace glint
