// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the readers of texts of words have in common: messages at a word.
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "formats/line_words.h"
#include "formats/load_state.h"

namespace glint {

class LineReader {
  protected:
    /// end_of: what ends where an expected word is missing, "line" or "file".
    LineReader(LoadState& reading, InputText where, LineWords::Syntax syntax, std::string_view end_of)
        : reading_(reading), where_(where), words_(where.text, syntax), end_of_(end_of) {}

    /// At the last word. False, as from expected().
    bool error(std::string message) {
        reading_.diagnostics.error(where_, words_.start(), words_.length(), std::move(message));
        return false;
    }
    bool expected(std::string_view what) {
        return error(words_.found().empty()
                         ? fmt::format("the {} ends here: expected {}", end_of_, what)
                         : fmt::format("expected {}, found {}", what, quoted(words_.found())));
    }
    void warn_once(std::string_view key, std::string message) {
        reading_.diagnostics.warn_once(key, where_, words_.start(), words_.length(), std::move(message));
    }

    LoadState& reading_;
    const InputText where_;
    LineWords words_;

  private:
    const std::string_view end_of_;
};

}  // namespace glint
