// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "glint/load.h"

namespace glint_floor {

/// The scene of a file in any format, with the files that it names, which are looked for beside it.
glint::Result<glint::Scene> read_scene(const std::string& path);

/// Prints why a program named `program` ends, and returns its exit code.
int fail(const char* program, const glint::Status& status);

}  // namespace glint_floor
