// SPDX-License-Identifier: Apache-2.0
// PPM and PGM, as text (P2, P3) and raw (P5, P6): https://netpbm.sourceforge.net/doc/ppm.html
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/status.h"
#include "image/decoders.h"

namespace glint {
namespace {

constexpr std::uint32_t k_largest = 65535;  // of a sample

bool is_space(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// After an error, all that it reads is 0.
class Reader {
  public:
    Reader(ByteSpan bytes, std::size_t at) : bytes_(bytes), at_(at) {}

    const Status& error() const { return error_; }

    std::size_t left() const { return bytes_.size() - at_; }
    std::uint8_t byte() { return bytes_[at_++]; }

    // Reads a whole number after spaces and comments.
    std::uint32_t number(const char* what, std::uint32_t most) {
        while (left() > 0 && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
            if (bytes_[at_] != '#') {
                ++at_;
            } else {
                while (left() > 0 && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
            }
        }
        if (left() == 0) return fail(fmt::format("the PPM file ends before {}", what));
        std::uint32_t value = 0;
        const std::size_t start = at_;
        for (; left() > 0 && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
            value = value * 10 + (bytes_[at_] - std::uint32_t{'0'});
            if (value > most) return fail(fmt::format("in the PPM file, {} is more than {}", what, most));
        }
        if (at_ == start)
            return fail(fmt::format("in the PPM file, byte {} is no number: expected {}", at_, what));
        return value;
    }

    // Reads the single space that ends a raw file's header.
    void end_header() {
        if (left() == 0 || !is_space(byte())) fail("in the PPM file, no space follows the maximum");
    }

  private:
    std::uint32_t fail(std::string message) {
        if (error_.ok()) error_ = undecodable(std::move(message));
        at_ = bytes_.size();
        return 0;
    }

    ByteSpan bytes_;
    std::size_t at_;
    Status error_;
};

}  // namespace

Result<DecodedPicture> decode_ppm(ByteSpan bytes, const DecoderOptions& options) {
    const bool is_grey = bytes[1] == '2' || bytes[1] == '5', is_raw = bytes[1] >= '5';
    Reader in(bytes, 2);
    // The limits are larger than the allowed size, so that check_size() reports the error.
    const std::uint32_t width = in.number("the width", 99999999);
    const std::uint32_t height = in.number("the height", 99999999);
    if (!in.error().ok()) return in.error();
    if (Status fault = size_fault(width, height, options); !fault.ok()) return fault;
    const std::uint32_t most = in.number("the maximum", k_largest);
    if (is_raw) in.end_header();
    if (!in.error().ok()) return in.error();
    if (most == 0) return undecodable("in the PPM file, the maximum is 0");
    const std::size_t pixels = std::size_t{width} * height, samples = pixels * (is_grey ? 1 : 3);
    const std::size_t bytes_each = most < 256 ? 1 : 2;
    // In a text file, a sample has at least two bytes; the last one has at least one.
    if (in.left() < (is_raw ? samples * bytes_each : 2 * samples - 1))
        return undecodable("the PPM file is cut off");

    const std::uint64_t row_bytes = 3 * bytes_each * width;
    Result<StoredPicture> picture = new_picture(width, height, most, row_bytes, options);
    if (!picture) return Status(std::move(picture));
    DecodedPicture result{*std::move(picture), most < 256 ? 8 : 16, {}};
    const auto sample = [&] {
        std::uint32_t value = 0;
        if (!is_raw) {
            value = in.number("a sample", most);
        } else {
            value = in.byte();
            if (bytes_each == 2) value = value << 8 | in.byte();
        }
        return std::min(value, most);
    };
    const auto read = [&](auto row) {
        using Number = typename decltype(row)::value_type;
        for (std::int32_t y = 0; y < result.picture.height && in.error().ok(); ++y) {
            for (std::size_t i = 0; i < row.size(); i += 3) {
                row[i] = static_cast<Number>(sample());
                for (std::size_t c = i + 1; c < i + 3; ++c)
                    row[c] = is_grey ? row[i] : static_cast<Number>(sample());
            }
            result.picture.put_row(y, row.data());
        }
    };
    if (bytes_each == 1)
        read(std::vector<std::uint8_t>(std::size_t{3} * width));
    else
        read(std::vector<std::uint16_t>(std::size_t{3} * width));
    if (!in.error().ok()) return in.error();
    return result;
}

}  // namespace glint
