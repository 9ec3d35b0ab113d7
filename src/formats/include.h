// SPDX-License-Identifier: Apache-2.0
#pragma once
// include "file": reads another text.
#include "formats/load_state.h"

namespace glint {

/// Reads the text `name`, relative to the text `from`, in the format of its extension, and adds its
/// items to the scene. Its camera and background are used only if no other text has one; its settings
/// are ignored. An error of the include itself is reported at `at`. format: of the text; empty: by its
/// extension.
void include_text(LoadState& reading, const ReadText& from, const Token& at, const std::string& name,
                  const std::string& format = {});

/// Opens the text `name`, relative to the text `from`, without reading it. Nothing after an error, which is
/// reported at `at`. A text is opened once.
std::optional<ReadText> open_text(LoadState& reading, const ReadText& from, const Token& at,
                                  const std::string& name);

/// The same for a text that the scene can do without: a warning that ends with `without` ("the shapes are
/// ...") instead of an error.
std::optional<ReadText> open_optional_text(LoadState& reading, const ReadText& from, const Token& at,
                                           const std::string& name, std::string_view without);

}  // namespace glint
