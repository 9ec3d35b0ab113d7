// SPDX-License-Identifier: Apache-2.0
// PNG for stb_image, which checks little: reads the chunks, and passes on a file with those that decide the
// texels. https://www.w3.org/TR/png/
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/png_checksum.h"
#include "image/texture_files.h"

namespace glint {
namespace {

constexpr std::string_view k_png_signature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t k_around_data = 12;      // of a chunk: length, name and checksum
constexpr std::size_t k_most_inflated = 1032;  // bytes that deflate makes of one (a figure of zlib)

std::uint32_t four_bytes(ByteSpan bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
           bytes[3];
}

// The chunks that decide the texels.
struct PngChunks {
    ByteSpan header, palette, transparency;
    std::vector<ByteSpan> data;
    std::size_t data_bytes = 0;
};

struct PngHeader {
    std::uint32_t width, height;
    int bits, color_type;
    bool is_interlaced;
    std::uint32_t channels() const {
        return (color_type & 2) != 0 && color_type != 3 ? 3 : 1;
    }  // without alpha
    bool has_alpha() const { return (color_type & 4) != 0; }
};

class PngWalk {
  public:
    explicit PngWalk(ByteSpan file) : file_(file) {}

    // Reads the chunks up to IEND.
    Status read(PngChunks& to) {
        std::size_t at = k_png_signature.size();
        while (true) {
            if (file_.size() - at < k_around_data) return undecodable("the PNG file is cut off");
            const std::size_t length = four_bytes(file_.subspan(at));
            if (length > file_.size() - at - k_around_data) return undecodable("the PNG file is cut off");
            const ByteSpan named = file_.subspan(at + 4, 4 + length);
            const std::string_view name(reinterpret_cast<const char*>(named.data()), 4);
            const bool is_first = at == k_png_signature.size();
            at += k_around_data + length;
            if (is_first != (name == "IHDR") && name != "CgBI")
                return undecodable("PNG: its first chunk is not IHDR, or there is another IHDR");
            if (Status fault = take(name, named, at - 4, to); !fault.ok()) return fault;
            if (name == "IEND") return {};
        }
    }

  private:
    Status take(std::string_view name, ByteSpan named, std::size_t checksum_at, PngChunks& to) {
        const bool is_needed = (named[0] & 32) == 0;  // an upper-case letter: decoders must know the chunk
        if (!is_needed && name != "tRNS") return {};
        if (name == "CgBI") return undecodable("PNG: Apple's variant (CgBI) is not read");
        const auto is_name = [name](std::string_view known) { return name == known; };
        static constexpr std::string_view known[] = {"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
        if (std::none_of(std::begin(known), std::end(known), is_name))
            return undecodable("PNG: an unknown chunk that is needed to decode it");
        if (png_checksum(named) != four_bytes(file_.subspan(checksum_at)))
            return undecodable(fmt::format("PNG: the checksum of {} is wrong", name));
        const ByteSpan data = named.subspan(4);
        if (name == "IHDR") to.header = data;
        if (name == "PLTE") to.palette = data;
        if (name == "tRNS") {
            if (!to.data.empty()) return undecodable("PNG: tRNS is after IDAT");
            to.transparency = data;
        }
        if (name == "IDAT") {
            to.data.push_back(data);
            to.data_bytes += data.size();
        }
        return {};
    }

    ByteSpan file_;
};

Status read_png_header(ByteSpan data, PngHeader& to) {
    if (data.size() != 13) return undecodable("PNG: IHDR has no 13 bytes");
    to = {four_bytes(data), four_bytes(data.subspan(4)), data[8], data[9], data[12] == 1};
    static constexpr int sets_of_bits[7] = {1 | 2 | 4 | 8 | 16, 0, 8 | 16, 1 | 2 | 4 | 8, 8 | 16, 0, 8 | 16};
    const bool is_power = to.bits > 0 && (to.bits & (to.bits - 1)) == 0;
    if (to.color_type > 6 || !is_power || (sets_of_bits[to.color_type] & to.bits) == 0)
        return undecodable(fmt::format("PNG: color type {} with {} bits", to.color_type, to.bits));
    if (data[10] != 0 || data[11] != 0 || data[12] > 1)
        return undecodable("PNG: an unknown method of its data");
    return {};
}

Status check_png_colors(const PngChunks& chunks, const PngHeader& header) {
    if (chunks.data.empty()) return undecodable("PNG: there is no IDAT");
    const std::size_t trns = chunks.transparency.size();
    if (header.color_type == 3) {
        const std::size_t bytes = chunks.palette.size();
        if (bytes == 0 || bytes % 3 != 0 || bytes > 3 * 256)
            return undecodable("PNG: the palette has no 1 to 256 colors");
        if (trns > bytes / 3) return undecodable("PNG: tRNS has more entries than the palette");
    } else if (trns > 0 && (header.has_alpha() || trns != 2 * header.channels())) {
        return undecodable("PNG: tRNS does not fit the color type");
    }
    return {};
}

void append_chunk(std::vector<std::uint8_t>& to, std::string_view name, std::size_t length) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<std::uint8_t>(length >> shift));
    to.insert(to.end(), name.begin(), name.end());
}

// stb_image reads no checksums.
void end_chunk(std::vector<std::uint8_t>& to) { to.insert(to.end(), 4, 0); }

// A file of these chunks alone. The palette has 256 colors, because stb_image reads beyond a smaller one.
std::vector<std::uint8_t> lean_png(const PngChunks& chunks, const PngHeader& header) {
    std::vector<std::uint8_t> to(k_png_signature.begin(), k_png_signature.end());
    to.reserve(chunks.data_bytes + 2048);
    const auto append = [&to](ByteSpan bytes) { to.insert(to.end(), bytes.begin(), bytes.end()); };
    append_chunk(to, "IHDR", chunks.header.size());
    append(chunks.header);
    end_chunk(to);
    if (header.color_type == 3) {
        append_chunk(to, "PLTE", 3 * 256);
        append(chunks.palette);
        to.insert(to.end(), 3 * 256 - chunks.palette.size(), 0);
        end_chunk(to);
    }
    if (!chunks.transparency.empty()) {
        append_chunk(to, "tRNS", chunks.transparency.size());
        append(chunks.transparency);
        end_chunk(to);
    }
    append_chunk(to, "IDAT", chunks.data_bytes);
    for (const ByteSpan data : chunks.data) append(data);
    end_chunk(to);
    append_chunk(to, "IEND", 0);
    end_chunk(to);
    return to;
}

// What stb_image takes at most: the data; the rows, twice as much again where it did not know their bytes;
// the picture, once more if interlaced; of a palette, the colors.
std::uint64_t stb_memory_of_png(const PngChunks& chunks, const PngHeader& header, bool has_alpha) {
    constexpr std::uint64_t rest = 1 << 16;
    const std::uint64_t pixels = std::uint64_t{header.width} * header.height,
                        stored = header.channels() + (header.has_alpha() ? 1 : 0),
                        row = (std::uint64_t{header.width} * static_cast<std::uint64_t>(header.bits) + 7) /
                                  8 * stored +
                              1,
                        made = pixels * (header.channels() + (has_alpha && header.color_type != 3 ? 1 : 0)) *
                               (header.bits == 16 ? 2 : 1);
    return chunks.data_bytes + (header.is_interlaced ? 3 : 1) * row * header.height +
           (header.is_interlaced ? 2 : 1) * made + (header.color_type == 3 ? 4 * pixels : 0) + rest;
}

}  // namespace

Result<TextureImage> decode_png_texture(ByteSpan file, const DecoderOptions& options) {
    const std::size_t begin = std::min(file.size(), k_png_signature.size());
    if (!std::equal(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(begin), k_png_signature.begin(),
                    [](std::uint8_t b, char c) { return b == static_cast<std::uint8_t>(c); }))
        return undecodable("PNG: its first bytes are damaged");
    if (begin < k_png_signature.size()) return undecodable("the PNG file is cut off");
    PngChunks chunks;
    PngHeader header{};
    if (Status fault = PngWalk(file).read(chunks); !fault.ok()) return fault;
    if (Status fault = read_png_header(chunks.header, header); !fault.ok()) return fault;
    if (Status fault = size_fault(header.width, header.height, options); !fault.ok()) return fault;
    if (Status fault = check_png_colors(chunks, header); !fault.ok()) return fault;
    const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
    if (pixels * static_cast<std::uint64_t>(header.bits) / 8 / k_most_inflated > chunks.data_bytes)
        return undecodable("PNG: too little data for its size");

    const bool has_alpha = header.has_alpha() || !chunks.transparency.empty();
    const StbPicture picture{"PNG", header.width, header.height, header.bits == 16,
                             stb_memory_of_png(chunks, header, has_alpha)};
    const std::uint64_t needed =
        picture.memory + chunks.data_bytes + texel_bytes(pixels, has_alpha, picture.is_wide);
    if (Status fault = decoding_fault(needed, pixels, options); !fault.ok()) return fault;
    return decode_by_stb(lean_png(chunks, header), picture);
}

}  // namespace glint
