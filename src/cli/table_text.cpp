// SPDX-License-Identifier: Apache-2.0
#include "cli/table_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace glint::cli {
namespace {

// RFC 4180. Spreadsheets would interpret a leading = + - @ as a formula.
std::string csv_cell(const std::string& text) {
    std::string safe = printable(text);
    if (!safe.empty() && std::string_view("=+-@").find(safe[0]) != std::string_view::npos)
        safe.insert(0, "'");
    if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;
    std::string quoted = "\"";
    for (const char c : safe) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

std::string aligned(std::vector<std::vector<std::string>> rows, std::size_t left_columns) {
    for (auto& row : rows) {
        for (std::string& cell : row) cell = printable(cell);  // their widths are those of what is printed
    }
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool left = i < left_columns || i + 1 == widths.size();
            line += left ? fmt::format("{:<{}}  ", row[i], widths[i])
                         : fmt::format("{:>{}}  ", row[i], widths[i]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
    return line + "\r\n";
}

}  // namespace glint::cli
