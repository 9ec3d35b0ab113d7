// SPDX-License-Identifier: Apache-2.0
// TGA: palettes, RGB and grey, raw and run-length encoded (types 1, 2, 3, 9, 10, 11), from any corner.
// Truevision TGA File Format Specification 2.0; without the areas at the end of the file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "image/texture_files.h"

namespace glint {
namespace {

using Texel = std::array<std::uint8_t, 4>;

constexpr std::size_t k_tga_header = 18;
constexpr std::size_t k_longest_run = 128;  // pixels in a packet

struct TgaHeader {
    std::size_t id_length;
    bool has_palette;
    int type;        // without run-length encoding: 1 palette, 2 RGB, 3 grey
    bool is_packed;  // run-length encoded
    std::uint32_t palette_first, palette_length;
    int palette_bits;
    std::uint32_t width, height;
    int bits;
    int attribute_bits;
    bool from_right, from_top;
    bool is_interleaved;  // rows in another order, which no program writes
};

std::uint32_t two_bytes(ByteSpan file, std::size_t at) { return file[at] + 256u * file[at + 1]; }

TgaHeader read_tga_header(ByteSpan file) {
    const int type = file[2], flags = file[17];
    return {file[0],           file[1] != 0,        type & 7,
            type >= 8,         two_bytes(file, 3),  two_bytes(file, 5),
            file[7],           two_bytes(file, 12), two_bytes(file, 14),
            file[16],          flags & 15,          (flags & 16) != 0,
            (flags & 32) != 0, (flags & 192) != 0};
}

bool has_colors(int bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }
std::size_t bytes_of(int bits) { return (static_cast<std::size_t>(bits) + 7) / 8; }

// Reads pixels and the colors of palettes.
class TgaReader {
  public:
    TgaReader(ByteSpan file, const TgaHeader& header) : file_(file), header_(header) {}

    bool skip(std::size_t bytes) {
        if (bytes > file_.size() - at_) return false;
        at_ += bytes;
        return true;
    }
    std::size_t left() const { return file_.size() - at_; }
    std::uint8_t byte() { return file_[at_++]; }

    // A color of so many bits; the caller has checked that it is there.
    Texel color(int bits) {
        const std::uint8_t* const b = file_.data() + at_;
        at_ += bytes_of(bits);
        if (bits >= 24) return {b[2], b[1], b[0], bits == 32 ? b[3] : std::uint8_t{255}};
        const std::uint32_t word = b[0] + 256u * b[1];
        const bool is_opaque = bits == 15 || header_.attribute_bits == 0 || word >= 32768;
        return {five_bits(word >> 10), five_bits(word >> 5), five_bits(word),
                std::uint8_t(is_opaque ? 255 : 0)};
    }

    bool read_palette() {
        if (!has_colors(header_.palette_bits))
            return skip(header_.palette_length * bytes_of(header_.palette_bits));
        if (header_.palette_length * bytes_of(header_.palette_bits) > left()) return false;
        for (std::uint32_t i = 0; i < header_.palette_length; ++i)
            palette_.push_back(color(header_.palette_bits));
        return true;
    }

    // The pixel at which the file is; false if an index is beyond the palette.
    bool pixel(Texel& to) {
        if (header_.type == 1) {
            index_ = byte();
            if (header_.bits == 16) index_ += 256u * byte();
            if (index_ < header_.palette_first || index_ - header_.palette_first >= palette_.size())
                return false;
            to = palette_[index_ - header_.palette_first];
        } else if (header_.type == 2) {
            to = color(header_.bits);
        } else {
            const std::uint8_t grey = byte(), alpha = header_.bits == 16 ? byte() : std::uint8_t{255};
            to = {grey, grey, grey, alpha};
        }
        return true;
    }
    std::uint32_t index() const { return index_; }

  private:
    static std::uint8_t five_bits(std::uint32_t word) {
        return static_cast<std::uint8_t>(((word & 31) * 255 + 15) / 31);
    }

    ByteSpan file_;
    const TgaHeader& header_;
    std::size_t at_ = 0;
    std::vector<Texel> palette_;
    std::uint32_t index_ = 0;
};

// Whether pixels may have another alpha than 255.
bool may_have_alpha(const TgaHeader& header) {
    if (header.type == 3) return header.bits == 16;
    const int bits = header.type == 1 ? header.palette_bits : header.bits;
    return bits == 32 || (bits == 16 && header.attribute_bits > 0);
}

// The places of pixels in the picture, in the order of the file.
class TgaPlaces {
  public:
    explicit TgaPlaces(const TgaHeader& header) : header_(header) {}
    std::size_t next() {
        const std::size_t x = header_.from_right ? header_.width - 1 - x_ : x_,
                          y = header_.from_top ? y_ : header_.height - 1 - y_;
        if (++x_ == header_.width) {
            x_ = 0;
            ++y_;
        }
        return y * header_.width + x;
    }

  private:
    const TgaHeader& header_;
    std::size_t x_ = 0, y_ = 0;
};

Status read_texels(TgaReader& in, const TgaHeader& header, std::vector<std::uint8_t>& words,
                   std::size_t each) {
    const std::size_t count = words.size() / each, pixel_bytes = bytes_of(header.bits);
    TgaPlaces places(header);
    Texel texel{};
    for (std::size_t done = 0; done < count;) {
        // A packet: pixels that follow one another, or one that is repeated. It may go on in the next row.
        std::size_t length = count - done;
        bool is_run = false;
        if (header.is_packed) {
            if (in.left() == 0) return undecodable("the TGA file is cut off");
            const std::uint8_t packet = in.byte();
            is_run = packet >= k_longest_run;
            length = std::min<std::size_t>(length, packet % k_longest_run + 1);
        }
        if ((is_run ? 1 : length) * pixel_bytes > in.left()) return undecodable("the TGA file is cut off");
        for (std::size_t i = 0; i < length; ++i, ++done) {
            if (!(is_run && i > 0) && !in.pixel(texel)) {
                return undecodable(fmt::format("TGA: the index {}, but the palette has the indices {} to {}",
                                               in.index(), header.palette_first,
                                               header.palette_first + header.palette_length - 1));
            }
            std::copy_n(texel.begin(), each, &words[each * places.next()]);
        }
    }
    return {};
}

// Alpha that is 0 everywhere is one that was left empty.
bool remove_empty_alpha(std::vector<std::uint8_t>& words) {
    for (std::size_t i = 3; i < words.size(); i += 4) {
        if (words[i] != 0) return false;
    }
    std::size_t to = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i % 4 != 3) words[to++] = words[i];
    }
    words.resize(to);
    return true;
}

}  // namespace

bool may_be_tga(ByteSpan file) {
    if (file.size() < k_tga_header) return false;
    const TgaHeader header = read_tga_header(file);
    if (file[1] > 1 || file[2] > 11 || (file[2] > 3 && file[2] < 9) || header.is_interleaved) return false;
    if (header.width == 0 || header.height == 0) return false;
    switch (header.type) {
        case 1:
            return header.has_palette && (header.bits == 8 || header.bits == 16) &&
                   has_colors(header.palette_bits);
        case 2:
            return has_colors(header.bits);
        case 3:
            return header.bits == 8 || header.bits == 16;
        default:
            return false;
    }
}

Result<TextureImage> decode_tga_texture(ByteSpan file, const DecoderOptions& options) {
    const TgaHeader header = read_tga_header(file);
    if (Status fault = size_fault(header.width, header.height, options); !fault.ok()) return fault;
    if (header.type == 1 && header.palette_length == 0) return undecodable("TGA: the palette is empty");
    TgaReader in(file, header);
    in.skip(k_tga_header);
    if (!in.skip(header.id_length) || (header.has_palette && !in.read_palette()))
        return undecodable("the TGA file is cut off");
    const std::uint64_t pixels = std::uint64_t{header.width} * header.height,
                        pixel_bytes = bytes_of(header.bits);
    const std::uint64_t least = header.is_packed
                                    ? (pixels + k_longest_run - 1) / k_longest_run * (1 + pixel_bytes)
                                    : pixels * pixel_bytes;
    if (least > in.left()) return undecodable("the TGA file is cut off");

    TextureImage image{header.width, header.height, may_have_alpha(header), {}};
    const std::uint64_t bytes = texel_bytes(pixels, image.has_alpha, false);
    if (Status fault = decoding_fault(bytes, pixels, options); !fault.ok()) return fault;
    std::vector<std::uint8_t> words(static_cast<std::size_t>(bytes));
    if (Status fault = read_texels(in, header, words, image.channels()); !fault.ok()) return fault;
    if (image.has_alpha && remove_empty_alpha(words)) image.has_alpha = false;
    image.words = std::move(words);
    return image;
}

}  // namespace glint
