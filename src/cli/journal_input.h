// SPDX-License-Identifier: Apache-2.0
#pragma once
// Journals that are read from the disk.
#include <string>

#include "cli/input_file.h"
#include "journal/journal.h"

namespace glint::cli {

/// A journal and its file, which the tiles refer to. Memory is given back while the file is read: a journal
/// may be larger than memory.
struct JournalInput {
    std::string name;
    InputFile file;
    Journal journal;
};

/// Parses a file; fails as parse_journal().
Result<JournalInput> read_journal(std::string name, InputFile file);

}  // namespace glint::cli
