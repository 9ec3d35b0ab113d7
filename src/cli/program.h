// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the main functions of the programs share.
#include <functional>
#include <string_view>

namespace glint::cli {

/// Ends the process by SIGPIPE, as a filter ends whose reader has gone: without a message (shells report
/// 141).
[[noreturn]] void end_by_broken_pipe();

/// Handles signals, calls body() and returns its exit code. Prints the message of an exception, and one if
/// standard output cannot be written to; `failure` is the exit code then.
int run_program(std::string_view name, int failure, const std::function<int()>& body);

}  // namespace glint::cli
