// SPDX-License-Identifier: Apache-2.0
#pragma once
// The corners of an .obj's faces: `1`, `1/2`, `1//3`, `1/2/3`, counted from 1, or from -1 backwards.
#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <string_view>

#include "formats/line_words.h"
#include "formats/load_state.h"
#include "glint/mesh.h"

namespace glint {

struct ObjCorner {
    std::uint32_t vertex = 0, normal = CornerValues::k_none, texture = CornerValues::k_none;
};

/// As written. 0: not there.
struct ObjIndices {
    std::int64_t vertex = 0, texture = 0, normal = 0;
};

/// False if the word is no corner. Nothing after a slash is as no slash.
inline bool read_obj_indices(std::string_view word, ObjIndices& indices) {
    const char* at = word.data();
    const char* const end = at + word.size();
    for (std::int64_t* const index : {&indices.vertex, &indices.texture, &indices.normal}) {
        if (index != &indices.vertex) {
            if (at == end) return true;
            if (*at++ != '/') return false;
            if (at == end || (*at == '/' && index == &indices.texture)) continue;
        }
        const auto [after, code] = std::from_chars(at, end, *index);
        if (code != std::errc() || *index == 0) return false;
        at = after;
    }
    return at == end;
}

/// The numbers of vertices, normals or texture coordinates. A face may come before its vertices.
class ObjNumbers {
  public:
    /// count: of those so far. False if a negative index goes beyond the first.
    bool resolve(std::int64_t index, std::size_t count, const LineWords& words, std::uint32_t& number) {
        constexpr std::int64_t most = CornerValues::k_none - 1;
        const std::int64_t from_zero = index > 0 ? index - 1 : static_cast<std::int64_t>(count) + index;
        if (from_zero < 0) return false;
        if (from_zero > greatest_) {
            greatest_ = from_zero;
            offset_ = words.start();
            length_ = words.length();
        }
        number = static_cast<std::uint32_t>(from_zero < most ? from_zero : most);
        return true;
    }
    /// At the end of the text. what: "vertex". False, and an error at the greatest number, if it is not
    /// there.
    bool check(std::size_t count, std::string_view what, LoadState& reading, InputText where) const {
        if (greatest_ < static_cast<std::int64_t>(count) && count < CornerValues::k_none) return true;
        reading.diagnostics.error(
            where, offset_, length_,
            fmt::format("expected the number of a {} from 1 to {}, found {}", what, count, greatest_ + 1));
        return false;
    }

    /// Whether a number is that of none of `count`.
    bool exceed(std::size_t count) const { return greatest_ >= static_cast<std::int64_t>(count); }

  private:
    std::int64_t greatest_ = -1;
    std::size_t offset_ = 0, length_ = 1;
};

}  // namespace glint
