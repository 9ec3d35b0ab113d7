// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures for commands that do more than write them to a file.
#include <string>

#include "cli/output_file.h"
#include "glint/glint.h"

namespace glint::cli {

/// Calls prepare(). Prints errors and throws Failure (bad input).
World prepare_or_fail(const Scene& scene, int threads = 0);

/// Calls render(). Throws Failure (bad input).
Image render_or_fail(const World& world, int threads = 0, const std::string& isa = {});

/// The destination of a PNG that an option writes. Throws a usage error if the name has the extension of
/// another format, and the errors of OutputFile.
OutputFile png_output(const char* option, const std::string& path);

/// Writes a picture as PNG; options.format is ignored. Throws Failure.
void write_png(const Image& picture, const OutputFile& output, EncodeOptions options = {});

}  // namespace glint::cli
