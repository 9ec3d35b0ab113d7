// SPDX-License-Identifier: Apache-2.0
#pragma once
// The error that ends a command, and the exit codes.
#include <stdexcept>
#include <string>

#include "glint/result.h"

namespace glint::cli {

inline constexpr int k_done = 0, k_bad_input = 1, k_usage = 2;

/// The meaning of the exit codes, for --help and the manual pages.
struct ExitCode {
    const char *code, *meaning;
};
inline constexpr ExitCode k_exit_codes[] = {
    {"0", "done"},
    {"1",
     "bad input: an error in a scene, or a file that cannot be read or written; `compare`: outside the "
     "limits; "
     "`--strict`: warnings"},
    {"2", "usage: the command line is not valid"},
    {"129, 130, 143",
     "ended by SIGHUP (the terminal was closed), SIGINT (Ctrl-C) or SIGTERM; shells report 128 plus "
     "the signal's number"},
};

/// Ends a command with a message on standard error. Commands throw it, main catches it.
class Failure : public std::runtime_error {
  public:
    Failure(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
    int code() const { return code_; }

  private:
    int code_;
};

/// Of a library call that failed, whose diagnostics are printed by the caller: they may say it all.
[[noreturn]] inline void throw_failure(const Status& status) {
    throw Failure(k_bad_input, has_errors(status.diagnostics) ? std::string() : status.message);
}

}  // namespace glint::cli
