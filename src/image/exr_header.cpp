// SPDX-License-Identifier: Apache-2.0
// The header of an OpenEXR file (https://openexr.com/en/latest/OpenEXRFileLayout.html): magic number and
// version, then attributes of name, type, length and value up to an empty name; a file of several parts has
// one header for each.
#include "image/exr_header.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace glint {
namespace {

// Types whose values have a fixed length.
struct FixedType {
    std::string_view name;
    std::uint32_t length;
};
constexpr FixedType k_fixed[] = {{"box2i", 16},
                                 {"box2f", 16},
                                 {"chromaticities", 32},
                                 {"compression", 1},
                                 {"deepImageState", 1},
                                 {"double", 8},
                                 {"envmap", 1},
                                 {"float", 4},
                                 {"int", 4},
                                 {"keycode", 28},
                                 {"lineOrder", 1},
                                 {"m33f", 36},
                                 {"m33d", 72},
                                 {"m44f", 64},
                                 {"m44d", 128},
                                 {"rational", 8},
                                 {"tiledesc", 9},
                                 {"timecode", 8},
                                 {"v2i", 8},
                                 {"v2f", 8},
                                 {"v2d", 16},
                                 {"v3i", 12},
                                 {"v3f", 12},
                                 {"v3d", 24}};
constexpr std::size_t k_channel_bytes = 16;  // after a channel's name
// Lines that are compressed together, by the number of the compression: none, RLE, ZIPS, ZIP, PIZ, PXR24,
// B44, B44A, DWAA, DWAB.
constexpr std::uint32_t k_block_lines[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
// OpenEXR's copies of the header's values and of a block, its memory for a name, and for a sample besides its
// channels.
constexpr std::uint64_t k_copies = 3, k_copies_of_block = 6, k_name_bytes = 1024, k_sample_bytes = 64;
// Of a block; the product of larger numbers would overflow.
constexpr std::uint64_t k_max_pixels = std::uint64_t{1} << 40, k_max_bytes = std::uint64_t{1} << 20;

[[noreturn]] void fail() { throw Undecodable("the OpenEXR file is cut off, or its header is not one"); }

class HeaderScan {
  public:
    explicit HeaderScan(ByteSpan bytes) : bytes_(bytes) {}

    ExrMemory check(const DecodeOptions& options) {
        if (bytes_.size() < 9) fail();
        at_ = 8;
        constexpr std::uint8_t k_deep = 0x08;  // in the same byte
        const bool is_deep = (bytes_[5] & k_deep) != 0;
        constexpr std::uint8_t k_multi_part =
            0x10;  // in the second byte of the version: several headers, ended by an empty one
        do {
            check_part(options);
        } while ((bytes_[5] & k_multi_part) != 0 && at_ < bytes_.size() && bytes_[at_] != 0);
        return {k_copies * at_ + k_name_bytes * names_ + block_bytes_, is_deep ? sample_bytes_ : 0, pixels_};
    }

  private:
    void check_part(const DecodeOptions& options) {
        width_ = height_ = 0;
        tile_width_ = tile_height_ = 0;
        pixel_bytes_ = 0;
        block_lines_ = 1;
        for (std::string_view name = text(); !name.empty(); name = text()) {
            const std::string_view type = text();
            const std::uint32_t length = number();
            if (length > bytes_.size() - at_) fail();
            const std::size_t end = at_ + length;
            check_length(type, length, end);
            if (name == "dataWindow" && type == "box2i") {
                const std::int64_t left = edge(), top = edge(), right = edge(), bottom = edge();
                width_ = right - left + 1;
                height_ = bottom - top + 1;
                check_size(width_, height_, options);
            } else if (name == "tiles" && type == "tiledesc") {
                tile_width_ = number();
                tile_height_ = number();
            } else if (name == "channels" && type == "chlist") {
                count_channels();
            } else if (name == "compression" && type == "compression") {
                block_lines_ = bytes_[at_] < std::size(k_block_lines) ? k_block_lines[bytes_[at_]] : 1;
            }
            at_ = end;
            ++names_;
        }
        check_tiles();
        add_blocks();
    }

    // After each name: the type, four bytes, and two distances between samples.
    void count_channels() {
        constexpr std::uint32_t k_half = 1;
        while (!text().empty()) {
            pixel_bytes_ += number() == k_half ? 2 : 4;
            at_ += k_channel_bytes - 4;
            ++names_;
        }
    }

    // The blocks of compressed lines, or the tiles, of one of which OpenEXR has some copies in memory; of
    // tiles also a row of them with the channels that are read.
    void add_blocks() {
        const auto width = static_cast<std::uint64_t>(width_), height = static_cast<std::uint64_t>(height_);
        const std::uint64_t pixels = tile_width_ == 0 ? width * std::min<std::uint64_t>(block_lines_, height)
                                                      : std::uint64_t{tile_width_} * tile_height_;
        const std::uint64_t block = std::min(pixels, k_max_pixels) * std::min(pixel_bytes_, k_max_bytes);
        const std::uint64_t row = width * tile_height_ * 3 * sizeof(float),
                            tables = 4 * sizeof(std::uint64_t) * height;
        pixels_ = std::max(pixels_, width * height);
        block_bytes_ = std::max(block_bytes_, k_copies_of_block * block + row + tables);
        sample_bytes_ = std::max(sample_bytes_, pixel_bytes_ + k_sample_bytes);
    }

    void check_length(std::string_view type, std::uint32_t length, std::size_t end) {
        for (const FixedType& fixed : k_fixed) {
            if (type == fixed.name && length != fixed.length) fail();
        }
        const std::size_t start = at_;
        if (type == "chlist") {
            while (!text().empty()) at_ += k_channel_bytes;
            if (at_ != end) fail();
        } else if (type == "preview") {
            if (length < 8 || std::uint64_t{number()} * number() > (length - 8) / 4) fail();
        }
        at_ = start;
    }

    // Every tile has an entry of eight bytes in the file's table of offsets.
    void check_tiles() const {
        if (tile_width_ == 0 || tile_height_ == 0) return;
        const auto count = [](std::int64_t side, std::int64_t tile) { return (side + tile - 1) / tile; };
        const std::int64_t tiles = count(width_, tile_width_) * count(height_, tile_height_);
        if (tiles > static_cast<std::int64_t>(bytes_.size() / 8)) fail();
    }

    // Reads up to a 0 byte.
    std::string_view text() {
        const std::size_t start = at_;
        while (at_ < bytes_.size() && bytes_[at_] != 0) ++at_;
        if (at_ >= bytes_.size()) fail();
        return {reinterpret_cast<const char*>(bytes_.data()) + start, at_++ - start};
    }

    std::uint32_t number() {
        if (at_ > bytes_.size() || bytes_.size() - at_ < 4) fail();
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;) value = value << 8 | bytes_[at_ + i];
        at_ += 4;
        return value;
    }
    std::int64_t edge() { return static_cast<std::int32_t>(number()); }

    ByteSpan bytes_;
    std::size_t at_ = 0;
    std::int64_t width_ = 0, height_ = 0;
    std::uint32_t tile_width_ = 0, tile_height_ = 0, block_lines_ = 1;
    std::uint64_t pixel_bytes_ = 0;  // of all channels
    // Of all parts: attributes and channels; the largest of each.
    std::uint64_t names_ = 0, block_bytes_ = 0, sample_bytes_ = 0, pixels_ = 0;
};

}  // namespace

ExrMemory check_exr_header(ByteSpan bytes, const DecodeOptions& options) {
    return HeaderScan(bytes).check(options);
}

}  // namespace glint
