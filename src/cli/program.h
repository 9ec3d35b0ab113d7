// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the main functions of the programs share.
#include <functional>
#include <string_view>

namespace glint::cli {

/// Handles signals, calls body() and returns its exit code. Prints the message of an exception, and one if
/// standard output cannot be written to; `failure` is the exit code then.
int run_program(std::string_view name, int failure, const std::function<int()>& body);

}  // namespace glint::cli
