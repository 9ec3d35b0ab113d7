// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a command says beside its answer.
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace glint::cli {

/// Writes to standard error. Where that cannot be written, nobody is told: the work goes on, and the exit
/// code is the work's.
template <class... Args> void print_error(fmt::format_string<Args...> format, Args&&... args) {
    const std::string text = fmt::format(format, std::forward<Args>(args)...);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace glint::cli
