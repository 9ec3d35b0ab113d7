// SPDX-License-Identifier: Apache-2.0
#include "cli/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/picture_output.h"
#include "os/files.h"

namespace glint::cli {

std::optional<Part> parse_part(const std::string& text) {
    if (text.empty()) return std::nullopt;
    Part part;
    const char *const first = text.data(), *const end = first + text.size();
    const auto number = std::from_chars(first, end, part.number);
    const bool has_slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
    const auto parts = std::from_chars(number.ptr + (has_slash ? 1 : 0), end, part.parts);
    if (!has_slash || parts.ec != std::errc() || parts.ptr != end || part.number < 1 ||
        part.number > part.parts) {
        throw Failure(k_usage, fmt::format("--part: expected K/N with K from 1 to N, as 2/4, found {}",
                                           glint::quoted(text)));
    }
    return part;
}

OutputFile tiles_output(const std::string& path, bool shows) {
    if (shows) throw Failure(k_usage, "--show needs a picture, and --part renders only some of its tiles");
    if (is_picture_path(path)) {
        throw Failure(k_usage, fmt::format("--output {}: --part writes tiles, no picture; name it FILE.tiles",
                                           glint::quoted(path)));
    }
    OutputFile output("--output", path);
    if (output.is_stream()) throw Failure(k_usage, "--part writes a regular file: name it with --output");
    return output;
}

bool has_all_tiles(const std::string& path, const JournalHeader& header) {
    std::string why;
    if (os::info_of(path).kind != os::FileKind::regular) return false;
    auto file = InputFile::open_own(path, why);
    if (!file) return false;
    const Result<JournalInput> input = read_journal(path, std::move(*file));
    if (!input || !header_difference(input->journal.header, header).empty()) return false;
    std::vector<std::uint32_t> numbers;
    for (const JournalTile& tile : input->journal.tiles) numbers.push_back(tile.number);
    std::sort(numbers.begin(), numbers.end());
    const std::vector<std::uint32_t> wanted = tiles_of_part(header);
    return std::includes(numbers.begin(), numbers.end(), wanted.begin(), wanted.end());
}

}  // namespace glint::cli
