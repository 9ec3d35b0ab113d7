// SPDX-License-Identifier: Apache-2.0
#pragma once
// Messages for arguments that are not valid.
#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace glint::cli {

/// The message for the arguments of `command` (or of `glint`), whose parsing threw `error`. Unknown
/// arguments are reported first, because a missing one may be misspelt.
std::string usage_message(const CLI::App& command, const CLI::ParseError& error);

/// What is wrong if an option of a command that was parsed has an empty value, as of a variable of the shell
/// that is not set; else empty.
std::string empty_value_message(const CLI::App& command);

/// What is wrong with `glint WORD ...` where WORD is no command of `app`; empty if WORD is an option of
/// `glint` itself, or a word with a dash that resembles no option. There is at least one argument.
std::string command_message(const CLI::App& app, std::span<const std::string> arguments);

}  // namespace glint::cli
