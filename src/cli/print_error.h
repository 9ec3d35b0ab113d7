// SPDX-License-Identifier: Apache-2.0
#pragma once
// Messages on standard error.
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "base/text.h"

namespace glint::cli {

/// Whether messages go to standard output, too, for callers that read only that.
class CopiesErrors {
  public:
    static bool get() { return copies_; }
    static void set(bool copies) { copies_ = copies; }

  private:
    inline static bool copies_ = false;
};

/// Writes to standard error, escaped (base/text.h). A failure to write there is ignored: the work continues,
/// and the exit code depends only on the work.
template <class... Args> void print_error(fmt::format_string<Args...> format, Args&&... args) {
    const std::string text = printable_lines(fmt::format(format, std::forward<Args>(args)...));
    std::fwrite(text.data(), 1, text.size(), stderr);
    if (CopiesErrors::get()) std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace glint::cli
