// SPDX-License-Identifier: Apache-2.0
#pragma once
// The command lines of programs with subcommands: glint and glint-mpi.
#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

/// What a command line asks for: the command, unless there is an answer or an error.
struct CommandLine {
    std::string command;  ///< its name; with an error, empty if the line names none
    std::string answer;   ///< for standard output: of --help and --version
    std::string error;    ///< what is not valid, without a newline
};

/// Parses the arguments with `app`, whose name is the program's. Never throws CLI::Error.
CommandLine parse_command_line(CLI::App& app, const std::vector<std::string>& arguments);

/// "glint render: MESSAGE", and where the help is; `command` may be empty.
std::string usage_error_text(std::string_view program, std::string_view command, std::string_view message);

}  // namespace glint::cli
