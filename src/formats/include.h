// SPDX-License-Identifier: Apache-2.0
#pragma once
// include "file": a text that another one names.
#include "formats/load_state.h"

namespace glint {

/// Reads the text `name`, as seen from the text `from`, by the format of its name's extension, and adds what
/// it holds to the scene. Its camera and background hold only if no other text gives one; its settings never
/// do. What is wrong with the include itself is an error at `at`.
void include_text(LoadState& reading, const ReadText& from, const Token& at, const std::string& name);

}  // namespace glint
