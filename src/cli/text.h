// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text functions for arguments and output.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "glint/glint.h"

namespace glint::cli {

struct Size {
    std::int64_t width = 0, height = 0;
};

/// Parses "640x480"; nothing if it is not two whole numbers (they may be 0 or too large).
std::optional<Size> parse_size(std::string_view text);

struct Pair {
    std::int32_t x = 0, y = 0;
};

/// Parses "320,200".
std::optional<Pair> parse_pair(std::string_view text);

/// Parses "320x240+10+20".
std::optional<Crop> parse_crop(std::string_view text);

/// The name of a file without its folders.
std::string_view file_name(std::string_view path);

/// 1024311 -> "1,024,311".
std::string with_commas(std::uint64_t number);

/// "1 warning", "0 warnings".
std::string counted(std::uint64_t number, std::string_view noun);

/// 12300000000 -> "12.3 GB"; powers of 1000.
std::string bytes_text(double bytes);

/// "a, b and c".
std::string joined(std::span<const std::string_view> words, std::string_view last = "and");

/// The continuation of "there is no command 'rendre'": "; did you mean `render`? (there are render, info and
/// check)", or "; there are render, info and check".
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

/// The file name of a path without its last extension.
std::string stem(std::string_view path);

/// The last extension with its dot, in lower case; empty if there is none.
std::string extension(std::string_view path);

}  // namespace glint::cli
