// SPDX-License-Identifier: Apache-2.0
#pragma once
// Messages on standard error.
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "base/text.h"

namespace glint::cli {

/// Whether messages go to standard output, too, for callers that read only that. False at first.
inline bool& copies_errors_to_output() {
    static bool copies = false;
    return copies;
}

/// Writes to standard error, escaped (base/text.h). A failure to write there is ignored: the work continues,
/// and the exit code depends only on the work.
template <class... Args> void print_error(fmt::format_string<Args...> format, Args&&... args) {
    const std::string text = printable_lines(fmt::format(format, std::forward<Args>(args)...));
    std::fwrite(text.data(), 1, text.size(), stderr);
    if (copies_errors_to_output()) std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace glint::cli
