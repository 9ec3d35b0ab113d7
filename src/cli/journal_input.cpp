// SPDX-License-Identifier: Apache-2.0
#include "cli/journal_input.h"

#include <utility>

namespace glint::cli {

Result<JournalInput> read_journal(std::string name, InputFile file) {
    constexpr std::size_t most = std::size_t{1} << 25;  // bytes of the file in memory
    std::size_t released = 0;
    Result<Journal> journal = parse_journal(file.text(), [&](std::size_t passed) {
        if (passed - released < most) return;
        file.release();
        released = passed;
    });
    if (!journal) return Status(journal);
    file.release();
    return JournalInput{std::move(name), std::move(file), *std::move(journal)};
}

}  // namespace glint::cli
