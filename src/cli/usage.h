// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is said of arguments that make no sense, in the command's own words.
#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace glint::cli {

/// What is wrong with the arguments of `command` (or of `glint`), whose parsing ended in `error`. Unknown
/// arguments come first, in their order: a missing one may be a misspelled one.
std::string usage_message(const CLI::App& command, const CLI::ParseError& error);

/// What is wrong with `glint WORD ...` where WORD is no command of `app`; empty if WORD is an option of
/// `glint` itself, or a word with a dash that resembles no option.
std::string command_message(const CLI::App& app, std::span<const std::string> arguments);

}  // namespace glint::cli
