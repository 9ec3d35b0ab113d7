// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the commands print. All texts leave here or in print_error(), so that nothing which a scene, a picture
// or the name of a file contains controls the terminal.
#include <string_view>

namespace glint::cli {

/// Writes lines to standard output, escaped (base/text.h).
void print_text(std::string_view text);

/// Writes JSON to standard output; what print_text() escapes is written as \u009b here.
void print_json(std::string_view json);

}  // namespace glint::cli
