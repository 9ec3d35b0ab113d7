// SPDX-License-Identifier: Apache-2.0
// JPEG for stb_image: checks the segments before it reads them, because it writes beyond its tables when one
// has too many codes, and goes on without tables that are missing. ITU-T T.81.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "image/texture_files.h"

namespace glint {
namespace {

constexpr int k_most_scans = 100;  // as of decode_jpeg.cpp

struct JpegComponent {
    std::uint32_t id, across, down, table;  // across, down: samples, in units of the coarsest component
    bool is_scanned;
};

struct JpegFrame {
    std::uint32_t width = 0, height = 0;
    bool is_progressive = false;
    std::size_t count = 0;
    std::array<JpegComponent, 4> components{};
};

class JpegWalk {
  public:
    explicit JpegWalk(ByteSpan file) : file_(file) {}

    // Checks the file up to its end marker; calls check_frame(frame) once the sizes are known.
    template <class Check> Status check(Check&& check_frame) {
        at_ = 2;
        while (true) {
            std::uint8_t marker = 0;
            if (Status fault = next_marker(marker); !fault.ok()) return fault;
            if (marker == 0xd9) return end();
            if (left() < 2) return cut_off();
            const std::size_t length = word(at_);
            if (length < 2) return undecodable("JPEG: a segment without its length");
            if (length > left()) return cut_off();
            const ByteSpan segment = file_.subspan(at_ + 2, length - 2);
            at_ += length;
            if (Status fault = take(marker, segment); !fault.ok()) return fault;
            if (is_frame(marker)) {
                if (Status fault = check_frame(frame_); !fault.ok()) return fault;
            }
            if (marker == 0xda) skip_scan();
        }
    }

    const JpegFrame& frame() const { return frame_; }

  private:
    static bool is_frame(std::uint8_t marker) { return marker >= 0xc0 && marker <= 0xc2; }
    static Status cut_off() { return undecodable("the JPEG file is cut off"); }
    std::size_t left() const { return file_.size() - at_; }
    std::uint32_t word(std::size_t at) const { return std::uint32_t{file_[at]} << 8 | file_[at + 1]; }

    Status next_marker(std::uint8_t& marker) {
        if (left() > 0 && file_[at_] != 0xff)
            return undecodable(fmt::format("JPEG: at byte {} is no marker", at_));
        while (left() > 0 && file_[at_] == 0xff) ++at_;
        if (left() == 0) return cut_off();
        marker = file_[at_++];
        return {};
    }

    // To the next marker that is neither data (FF 00) nor between parts of the scan (D0 to D7).
    void skip_scan() {
        for (; left() > 1; ++at_) {
            if (file_[at_] != 0xff) continue;
            const std::uint8_t next = file_[at_ + 1];
            if (next != 0 && next != 0xff && (next < 0xd0 || next > 0xd7)) return;
        }
        at_ = file_.size();
    }

    Status take(std::uint8_t marker, ByteSpan segment) {
        switch (marker) {
            case 0xc0:
            case 0xc1:
            case 0xc2:
                return take_frame(segment, marker == 0xc2);
            case 0xc4:
                return take_codes(segment);
            case 0xda:
                return take_scan(segment);
            case 0xdb:
                return take_quantization(segment);
            case 0xdc:
            case 0xdd:
                return segment.size() == 2 ? Status{} : undecodable("JPEG: a segment of another length");
            case 0xee:
                take_adobe(segment);
                return {};
            default:
                break;
        }
        if ((marker >= 0xe0 && marker <= 0xef) || marker == 0xfe) return {};
        if (marker > 0xc2 && marker < 0xd0)
            return undecodable("JPEG: neither baseline nor progressive with Huffman codes");
        return undecodable(fmt::format("JPEG: the unknown marker {:02X}", marker));
    }

    Status take_frame(ByteSpan segment, bool is_progressive) {
        if (frame_.count > 0) return undecodable("JPEG: it has two frames");
        if (segment.size() < 6) return undecodable("JPEG: a frame of another length");
        if (segment[0] != 8)
            return undecodable(fmt::format("JPEG: {} bits a channel; those read have 8", segment[0]));
        frame_.height = std::uint32_t{segment[1]} << 8 | segment[2];
        frame_.width = std::uint32_t{segment[3]} << 8 | segment[4];
        frame_.count = segment[5];
        frame_.is_progressive = is_progressive;
        if (frame_.count != 1 && frame_.count != 3 && frame_.count != 4)
            return undecodable(fmt::format("JPEG: {} channels; those read have 1, 3 or 4", frame_.count));
        if (segment.size() != 6 + 3 * frame_.count) return undecodable("JPEG: a frame of another length");
        for (std::size_t i = 0; i < frame_.count; ++i) {
            const ByteSpan from = segment.subspan(6 + 3 * i, 3);
            const JpegComponent component{from[0], from[1] / 16u, from[1] % 16u, from[2], false};
            if (component.across < 1 || component.across > 4 || component.down < 1 || component.down > 4 ||
                component.table > 3)
                return undecodable("JPEG: a channel with an unknown number of samples or table");
            frame_.components[i] = component;
        }
        return {};
    }

    Status take_quantization(ByteSpan segment) {
        while (!segment.empty()) {
            const unsigned number = segment[0] % 16, precision = segment[0] / 16;
            const std::size_t length = precision == 0 ? 65 : 129;
            if (number > 3 || precision > 1 || segment.size() < length)
                return undecodable("JPEG: a quantization table of another length");
            tables_ |= 1u << number;
            segment = segment.subspan(length);
        }
        return {};
    }

    Status take_codes(ByteSpan segment) {
        while (!segment.empty()) {
            const unsigned number = segment[0] % 16, kind = segment[0] / 16;
            if (number > 3 || kind > 1 || segment.size() < 17)
                return undecodable("JPEG: an unknown table of codes");
            std::size_t codes = 0;
            for (const std::uint8_t count : segment.subspan(1, 16)) codes += count;
            if (codes > 256 || segment.size() < 17 + codes)
                return undecodable("JPEG: a table of codes of another length");
            codes_ |= 1u << (4 * kind + number);
            segment = segment.subspan(17 + codes);
        }
        return {};
    }

    Status take_scan(ByteSpan segment) {
        if (++scans_ > k_most_scans)
            return undecodable(fmt::format("JPEG: more than {} passes", k_most_scans));
        const std::size_t count = segment.empty() ? 0 : segment[0];
        if (frame_.count == 0 || count < 1 || count > frame_.count || segment.size() != 4 + 2 * count)
            return undecodable("JPEG: a pass that does not fit the frame");
        const unsigned first = segment[1 + 2 * count], is_refined = segment[3 + 2 * count] / 16;
        const bool has_mean = !frame_.is_progressive || first == 0,
                   has_rest = !frame_.is_progressive || first > 0;
        for (std::size_t i = 0; i < count; ++i) {
            const unsigned id = segment[1 + 2 * i], tables = segment[2 + 2 * i];
            const auto component =
                std::find_if(frame_.components.begin(), frame_.components.begin() + frame_.count,
                             [id](const JpegComponent& c) { return c.id == id; });
            if (component == frame_.components.begin() + frame_.count)
                return undecodable("JPEG: a pass of an unknown channel");
            if (tables / 16 > 3 || tables % 16 > 3) return undecodable("JPEG: an unknown table of codes");
            const bool lacks_mean = has_mean && is_refined == 0 && (codes_ >> tables / 16 & 1) == 0,
                       lacks_rest = has_rest && (codes_ >> (4 + tables % 16) & 1) == 0;
            if (lacks_mean || lacks_rest || (tables_ >> component->table & 1) == 0)
                return undecodable("JPEG: a table is missing");
            component->is_scanned |= has_mean;
            if (!component->is_scanned) return undecodable("JPEG: a pass refines what is not there");
        }
        return {};
    }

    void take_adobe(ByteSpan segment) {
        constexpr std::string_view name = "Adobe";
        if (segment.size() >= 12 && std::equal(name.begin(), name.end(), segment.begin()))
            adobe_ = segment[11];
    }

    Status end() const {
        const auto first = frame_.components.begin();
        const auto is_scanned = [](const JpegComponent& c) { return c.is_scanned; };
        if (frame_.count == 0 || !std::all_of(first, first + frame_.count, is_scanned))
            return undecodable("JPEG: a channel is missing");
        if (frame_.count == 4 && adobe_ != 0 && adobe_ != 2)
            return undecodable("JPEG: four channels that are not CMYK as Adobe writes it");
        return {};
    }

    ByteSpan file_;
    std::size_t at_ = 0;
    JpegFrame frame_;
    unsigned tables_ = 0, codes_ = 0;  // a bit for each that is defined; of codes, first those of the means
    int scans_ = 0;
    int adobe_ = -1;
};

// What stb_image takes at most: the samples, of a progressive file the coefficients too, the picture and
// rows.
std::uint64_t stb_memory_of_jpeg(const JpegFrame& frame) {
    constexpr std::uint64_t rest = 1 << 16;
    std::uint64_t across = 1, down = 1, samples = 0;
    for (const JpegComponent& c : frame.components) {
        across = std::max<std::uint64_t>(across, c.across);
        down = std::max<std::uint64_t>(down, c.down);
    }
    const std::uint64_t blocks =
        ((frame.width + 8 * across - 1) / (8 * across)) * ((frame.height + 8 * down - 1) / (8 * down));
    for (const JpegComponent& c : frame.components) samples += 64 * blocks * c.across * c.down;
    return (frame.is_progressive ? 3 : 1) * samples +
           std::uint64_t{frame.width} * (4 + frame.height * std::uint64_t{frame.count == 1 ? 1u : 3u}) + rest;
}

}  // namespace

Result<TextureImage> decode_jpeg_texture(ByteSpan file, const DecoderOptions& options) {
    JpegWalk walk(file);
    StbPicture picture{"JPEG", 0, 0, false, 0};
    Status fault = walk.check([&](const JpegFrame& frame) -> Status {
        if (Status wrong = size_fault(frame.width, frame.height, options); !wrong.ok()) return wrong;
        const std::uint64_t pixels = std::uint64_t{frame.width} * frame.height;
        // A block of 8 x 8 pixels takes at least one bit.
        if (pixels / 64 > 8 * std::uint64_t{file.size()})
            return undecodable("JPEG: the file is too short for its size");
        picture = {"JPEG", frame.width, frame.height, false, stb_memory_of_jpeg(frame)};
        return decoding_fault(picture.memory + texel_bytes(pixels, false, false), pixels, options);
    });
    if (!fault.ok()) return fault;
    return decode_by_stb(file, picture);
}

}  // namespace glint
