// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tables as text and as CSV.
#include <string>
#include <vector>

namespace glint::cli {

/// Columns as wide as their widest cell, two spaces apart. The first `left_columns` and the last column are
/// aligned to the left, the others to the right. Cells are escaped (base/text.h).
std::string aligned(std::vector<std::vector<std::string>> rows, std::size_t left_columns);

/// A line of CSV (RFC 4180), of escaped cells (base/text.h). A cell that a spreadsheet would interpret as a
/// formula begins with an apostrophe.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace glint::cli
