// SPDX-License-Identifier: Apache-2.0
#pragma once
// Options that may be given more than once.
#include <CLI/CLI.hpp>

namespace glint::cli {

/// Lets an option of a list be repeated. Each use takes exactly one value: CLI11 would also take the
/// positional arguments that follow.
inline CLI::Option* repeated(CLI::Option* option) {
    return option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace glint::cli
