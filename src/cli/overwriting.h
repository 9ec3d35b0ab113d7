// SPDX-License-Identifier: Apache-2.0
#pragma once
// No command writes over a file that it reads, or twice to one file. All files pass here when they are
// opened.
#include <filesystem>
#include <string>

namespace glint::cli {

/// The absolute path of what `path` names: with symbolic links followed, also one that names no file yet.
std::filesystem::path followed(const std::string& path);

/// Takes note of a file that will be written. Throws Failure of usage if it has been read, or is written by
/// another option too. `option` names it in messages: "--stats".
void note_output(const std::string& option, const std::string& path);

/// Registers standard output. Throws a usage error if another option uses it.
void note_standard_output(const std::string& option);

/// Registers an open file that is read. Throws a usage error if it will be written.
void note_input(int descriptor);

}  // namespace glint::cli
