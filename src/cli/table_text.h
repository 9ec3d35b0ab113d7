// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tables as text and as CSV.
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

/// Columns as wide as their widest cell, two spaces apart. The first `left_columns` and the last column are
/// aligned to the left, the others to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left_columns);

/// The text with "?" for control characters (also U+0080 to U+009F) and for bytes that are not UTF-8: names
/// of files and of a rubric's parts must not control the terminal.
std::string printable(std::string_view text);

/// A line of CSV (RFC 4180). A cell that a spreadsheet would interpret as a formula begins with an
/// apostrophe.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace glint::cli
