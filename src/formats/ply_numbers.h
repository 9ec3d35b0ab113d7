// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers after the header of a PLY file, as text or binary.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

#include "formats/number_text.h"
#include "formats/ply_header.h"

namespace glint {

/// Numbers of a text, separated by blanks.
class PlyText {
  public:
    PlyText(std::string_view text, std::size_t from, PlyCoding)
        : text_(text), at_(text.data() + from), start_(at_) {}

    std::size_t offset() const { return static_cast<std::size_t>(at_ - text_.data()); }
    /// Of the number that next() has read or has not found.
    std::size_t start() const { return static_cast<std::size_t>(start_ - text_.data()); }
    std::string_view found() const {
        const std::string_view rest = text_.substr(start());
        return rest.substr(0, rest.find_first_of(" \t\r\n"));
    }
    bool next(PlyType, double& value) {
        const char* const end = text_.data() + text_.size();
        while (at_ != end && is_blank(*at_)) ++at_;
        start_ = at_;
        const char* from = at_ != end && *at_ == '+' ? at_ + 1 : at_;
        if (from == end) return false;
        const char* after = read_short_number(from, end, value, [](char c) { return !is_blank(c); });
        if (after == nullptr) after = read_any_number(from, end, value);
        if (after == from || (after != end && !is_blank(*after))) return false;
        at_ = after;
        return true;
    }

  private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
    std::string_view text_;
    const char* at_;
    const char* start_;
};

/// Binary numbers.
class PlyBinary {
  public:
    PlyBinary(std::string_view text, std::size_t from, PlyCoding coding)
        : text_(text), at_(from), is_big_(coding == PlyCoding::big_endian) {}

    std::size_t offset() const { return at_; }
    bool next(PlyType type, double& value) {
        switch (type) {
            case PlyType::int8:
                return take<std::int8_t>(value);
            case PlyType::uint8:
                return take<std::uint8_t>(value);
            case PlyType::int16:
                return take<std::int16_t>(value);
            case PlyType::uint16:
                return take<std::uint16_t>(value);
            case PlyType::int32:
                return take<std::int32_t>(value);
            case PlyType::uint32:
                return take<std::uint32_t>(value);
            case PlyType::float32:
                return take<float>(value);
            case PlyType::float64:
                return take<double>(value);
        }
        return false;
    }

  private:
    template <class T> bool take(double& value) {
        std::array<char, sizeof(T)> bytes;
        if (text_.size() - at_ < sizeof(T)) return false;
        std::memcpy(bytes.data(), text_.data() + at_, sizeof(T));
        if (is_big_) std::reverse(bytes.begin(), bytes.end());
        value = static_cast<double>(std::bit_cast<T>(bytes));
        at_ += sizeof(T);
        return true;
    }
    std::string_view text_;
    std::size_t at_;
    bool is_big_;
};

}  // namespace glint
