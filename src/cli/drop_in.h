// SPDX-License-Identifier: Apache-2.0
#pragma once
// glint-tachyon and glint-povray: other programs' command lines, rendered by glint.
#include <string>
#include <vector>

#include "cli/render_arguments.h"

namespace glint::cli {

/// A command line of another program, as the arguments of `glint render`.
struct DropIn {
    RenderArguments render;
    std::vector<std::string> warnings;  ///< what has another effect here, or none
    bool wants_help = false, wants_version = false;
};

/// Tachyon's command line (`tachyon -help`). Throws a usage Failure that names an unknown flag.
DropIn tachyon_drop_in(const std::vector<std::string>& arguments);

/// POV-Ray's command line: switches (+W640), `Key=Value` and .ini files, which are read. Throws a usage
/// Failure that names an unknown switch or key, with its line in the file; of input if a file cannot be read.
DropIn povray_drop_in(const std::vector<std::string>& arguments);

/// A program's name and its failures' exit code, for run_drop_in().
struct DropInProgram {
    std::string name, help;
    int failure;
    DropIn (*parse)(const std::vector<std::string>&);
};

/// The whole program: parses, renders, prints messages. Returns the exit code.
int run_drop_in(const DropInProgram& program, int count, char** values);

}  // namespace glint::cli
