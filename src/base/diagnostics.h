// SPDX-License-Identifier: Apache-2.0
#pragma once
// Collects messages while a text is read. Places are byte offsets until a message is made.
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/diagnostic.h"

namespace glint {

/// Converts byte `offset` of `text` to line and column (from 1, in bytes).
struct LineColumn {
    std::uint32_t line = 1, column = 1;
};
LineColumn line_column(std::string_view text, std::size_t offset);

/// A text that is being read, and its name.
struct InputText {
    std::string_view name;
    std::string_view text;
};

/// The diagnostic for bytes [offset, offset + length) of a text, with its source line. A long line is
/// shortened around the place.
Diagnostic make_diagnostic(Severity severity, InputText where, std::size_t offset, std::size_t length,
                           std::string message);

/// "file:line:col", "file", or the path of an item of a list; empty if the message has no place.
std::string place_text(const Diagnostic& diagnostic);

/// The diagnostic for the word at a place (line > 0) of a text.
Diagnostic diagnostic_at(Severity severity, InputText where, SourcePlace place, std::string message);

/// A bounded list of diagnostics: at most max_errors errors, and 100 warnings and notes. warn_once() adds
/// one warning for each key.
class Diagnostics {
  public:
    explicit Diagnostics(std::uint32_t max_errors = 20) : max_errors_(max_errors) {}
    void add(Diagnostic diagnostic);
    void error(InputText where, std::size_t offset, std::size_t length, std::string message);
    /// An error about something that LoadOptions::skip_unsupported leaves out.
    void refuse(InputText where, std::size_t offset, std::size_t length, std::string message);
    void warn(InputText where, std::size_t offset, std::size_t length, std::string message);
    void warn_once(std::string_view key, InputText where, std::size_t offset, std::size_t length,
                   std::string message);
    /// True if warn_once() with this key would add nothing.
    bool warned(std::string_view key) const;
    /// True when reading should stop: after max_errors errors, or if the watcher returned false.
    bool full() const { return errors_ >= max_errors_ || is_stopped_; }
    /// Called by readers at intervals, with their text and their place in it. Returns false to stop them.
    using Watcher = std::function<bool(InputText where, std::size_t offset)>;
    void set_watcher(Watcher watcher) { watcher_ = std::move(watcher); }
    /// False when reading should stop.
    bool go_on(InputText where, std::size_t offset) {
        if (watcher_ && !watcher_(where, offset)) is_stopped_ = true;
        return !full();
    }
    bool is_stopped() const { return is_stopped_; }
    bool any_errors() const { return errors_ != 0; }
    std::uint32_t error_count() const { return errors_; }
    std::vector<Diagnostic> take() { return std::move(list_); }
    const std::vector<Diagnostic>& list() const { return list_; }

  private:
    std::vector<Diagnostic> list_;
    std::vector<std::string> once_;
    std::uint32_t errors_ = 0, warnings_ = 0, max_errors_;
    Watcher watcher_;
    bool is_stopped_ = false;
};

}  // namespace glint
