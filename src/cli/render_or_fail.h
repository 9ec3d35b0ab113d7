// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's picture inside a command that wants more of it than a file.
#include <string>

#include "cli/output_file.h"
#include "glint/glint.h"

namespace glint::cli {

/// prepare(), or a Failure of input after printing what is wrong.
World prepare_or_fail(const Scene& scene, int threads = 0);

/// render(), or a Failure of input.
Image render_or_fail(const World& world, int threads = 0, const std::string& isa = {});

/// Where an option's PNG goes. Throws Failure of usage if its name promises another format, else as
/// OutputFile does.
OutputFile png_output(const char* option, const std::string& path);

/// Writes a picture as PNG, whatever the options' format is. Throws Failure.
void write_png(const Image& picture, const OutputFile& output, EncodeOptions options = {});

}  // namespace glint::cli
