// SPDX-License-Identifier: Apache-2.0
#pragma once
// glint-tachyon and glint-povray: other programs' command lines, rendered by glint.
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/render_arguments.h"

namespace glint::cli {

/// A picture of an animation.
struct DropInFrame {
    std::string output;
    std::vector<std::pair<std::string, double>> declared;  ///< `clock`, `frame_number` ...
};

/// A command line of another program, as the arguments of `glint render`.
struct DropIn {
    RenderArguments render;
    std::vector<std::string> warnings;  ///< what has another effect here, or none
    std::vector<DropInFrame> frames;    ///< of an animation; none: one picture
    bool wants_help = false, wants_version = false;
};

/// Tachyon's command line (`tachyon -help`). Throws a usage Failure that names an unknown flag.
DropIn tachyon_drop_in(const std::vector<std::string>& arguments);

/// POV-Ray's .ini files: those of the machine, or others in tests.
class IniFiles {
  public:
    virtual ~IniFiles() = default;
    /// Whether there is such a file.
    virtual bool exists(const std::string& path);
    /// Its text; it must be a regular file unless the user names it. Throws a Failure of input if it cannot
    /// be read.
    virtual std::string read(const std::string& path, bool is_users);
};

/// POV-Ray's command line: switches (+W640), `Key=Value` and .ini files, which are read. Throws a usage
/// Failure that names an unknown switch or key, with its line in the file; of input if a file cannot be read.
DropIn povray_drop_in(const std::vector<std::string>& arguments, IniFiles& files);
/// The same with the machine's files.
DropIn povray_drop_in(const std::vector<std::string>& arguments);

/// A line of the help: "-o FILE" or "-trans_vmd, -trans_orig", and what it does. Switches before a value
/// without a blank, as +W640, have the value in brackets there: "+W[N]".
struct DropInOption {
    std::string_view names, text;
    std::string_view values = {};  ///< the possible ones, separated by blanks
};

/// A program: the text of its help, its manual page and its completions; and what it does.
struct DropInProgram {
    std::string_view name;     ///< "glint-tachyon"
    std::string_view purpose;  ///< what it does, beginning with a verb
    std::string_view usage;    ///< its arguments
    std::span<const DropInOption> options;
    std::string_view notes;       ///< a paragraph after the options; or empty
    std::string_view examples;    ///< lines
    std::string_view extensions;  ///< of the files that it takes, separated by blanks
    int failure;                  ///< the exit code
    DropIn (*parse)(const std::vector<std::string>&);
    /// If it is called by this name, a refusal is printed and ends as that program's own; or empty.
    std::string_view stands_for;
    std::string_view refusal;  ///< the last line, on standard output, of such a refusal; its exit code is 0
};

extern const DropInProgram k_tachyon_program, k_povray_program;
/// All of them.
std::array<const DropInProgram*, 2> drop_in_programs();
/// The program `glint-NAME` or `NAME`; null if there is none.
const DropInProgram* find_drop_in(std::string_view name);

/// What --help prints.
std::string drop_in_help(const DropInProgram& program);
/// What a program's failure code means.
inline constexpr const char* k_drop_in_failure =
    "the command line, the scene or a file is not valid; the message says why";
/// The script for the shell: bash, zsh or fish.
std::string drop_in_completion(const DropInProgram& program, std::string_view shell);

/// The program whose name, or that of the one whose place it takes, the command is called by: links to the
/// command have these names. Null by any other name.
const DropInProgram* called_drop_in(std::string_view called);
/// The whole program: parses, renders, prints messages. Returns the exit code.
int run_drop_in(const DropInProgram& program, std::string_view called, const std::vector<std::string>& words);

}  // namespace glint::cli
