#pragma once
// A scene's picture inside a command that wants more of it than a file.
#include <string>

#include "cli/output_file.h"
#include "glint/glint.h"

namespace glint::cli {

/// prepare(), or a Failure of input after printing what is wrong.
WorldPtr prepare_or_fail(const Scene& scene, int threads = 0);

/// render(), or a Failure of input.
Image draw(const World& world, int threads = 0, const std::string& isa = {});

/// Writes a picture as PNG. Throws Failure.
void write_png(const Image& picture, const OutputFile& output, int threads = 0);

}  // namespace glint::cli
