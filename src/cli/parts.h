// SPDX-License-Identifier: Apache-2.0
#pragma once
// Rendering some of a picture's tiles.
#include <cstdint>
#include <optional>
#include <string>

#include "cli/journal_input.h"
#include "cli/output_file.h"

namespace glint::cli {

/// The Kth of N parts.
struct Part {
    std::uint32_t number = 1, parts = 1;
};

/// The value of --part, "2/4"; none if it is empty. Throws Failure of usage.
std::optional<Part> parse_part(const std::string& text);

/// Where a part's tiles go. Throws Failure of usage if `path` is the name of a picture, or if they cannot be
/// shown.
OutputFile tiles_output(const std::string& path, bool shows);

/// True if the file is a journal of this picture that has all tiles of its part.
bool has_all_tiles(const std::string& path, const JournalHeader& header);

}  // namespace glint::cli
