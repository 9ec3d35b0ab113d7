// SPDX-License-Identifier: Apache-2.0
#pragma once
// The running program, its standard streams and what ends it.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace glint::os {

/// main()'s arguments as UTF-8, with the program's name first. On Windows '\\' has become '/'.
std::vector<std::string> arguments(int count, char** values);

/// The name of a program by that of its file: on Windows without .exe, in lower case.
std::string name_of_program(std::string file);

/// Standard input and output carry bytes as they are, and terminals show UTF-8 and obey escape sequences.
void prepare_streams();

bool is_terminal(int descriptor);
/// Whether a terminal can show a line again in another state.
bool can_redraw(int descriptor);
/// The width of a terminal in characters; 80 if it is not known.
int terminal_columns(int descriptor);

enum class Ending { interrupt, other, file_shrank };
/// Calls clean_up() when the user or the system ends the program (Ctrl-C, a closed terminal, a signal), which
/// then ends. A signal handler: clean_up() must only use what is allowed there. A mapped file that becomes
/// shorter ends the program with the exit code that clean_up() returns.
void on_ending(int (*clean_up)(Ending));

/// After writing to standard output failed: whether it is a pipe that nobody reads any more. `error`: errno
/// of that, or 0 if it is not known.
bool reader_is_gone(int error);
/// Ends the process as a filter ends whose reader has gone: by SIGPIPE, without a message; shells report 141.
[[noreturn]] void end_by_broken_pipe();

std::uint64_t peak_memory();      ///< in bytes, of this process
double physical_memory();         ///< in bytes
std::filesystem::path program();  ///< the running program's file; empty if it is not known

}  // namespace glint::os
