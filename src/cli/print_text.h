// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the commands print. All texts leave here or in print_error(), so that nothing which a scene, a picture
// or the name of a file contains controls the terminal.
#include <string_view>

namespace glint::cli {

/// Writes lines to standard output, escaped (base/text.h).
void print_text(std::string_view text);

/// The same, but where colors are printed, the colored blocks that swatch() writes stay as they are.
void print_text_with_swatches(std::string_view text);

/// Whether texts on standard output have colors: it is a terminal, and NO_COLOR (no-color.org) is not set or
/// is empty.
bool prints_colors();

/// Writes JSON to standard output; what print_text() escapes is written as \u009b here.
void print_json(std::string_view json);

}  // namespace glint::cli
