// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace glint {
namespace {

constexpr std::size_t k_max_shown = 160;  // bytes of a source line shown in a message
constexpr std::uint32_t k_max_warnings = 100;

// The byte offset of a place; the end of the text if the line does not exist.
std::size_t offset_of(std::string_view text, SourcePlace place) {
    std::size_t start = 0;
    for (std::uint32_t line = 1; line < place.line; ++line) {
        const std::size_t end = text.find('\n', start);
        if (end == std::string_view::npos) return text.size();
        start = end + 1;
    }
    return std::min(start + place.column - 1, text.size());
}

}  // namespace

LineColumn line_column(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    const auto before = text.substr(0, offset);
    const auto line = static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n') + 1);
    const std::size_t start = before.rfind('\n') + 1;  // npos + 1 == 0
    return {line, static_cast<std::uint32_t>(offset - start + 1)};
}

Diagnostic make_diagnostic(Severity severity, InputText where, std::size_t offset, std::size_t length,
                           std::string message) {
    offset = std::min(offset, where.text.size());
    const auto [line, column] = line_column(where.text, offset);
    const std::size_t start = offset - (column - 1);
    std::size_t end = where.text.find_first_of("\r\n", offset);
    if (end == std::string_view::npos) end = where.text.size();
    // Shows only the part of a very long line around the place.
    const std::size_t shown = std::max(start, offset > k_max_shown / 2 ? offset - k_max_shown / 2 : 0);
    const std::size_t shown_end = std::min(end, shown + k_max_shown);
    Diagnostic d;
    d.severity = severity;
    d.file = std::string(where.name);
    d.line = line;
    d.column = column;
    d.length = static_cast<std::uint32_t>(
        std::clamp<std::size_t>(length, 1, std::max<std::size_t>(1, shown_end - offset)));
    d.message = std::move(message);
    for (auto rest = where.text.substr(shown, shown_end - shown); !rest.empty();) {
        // Control characters would move the caret or change the terminal's state; invalid UTF-8 would make
        // invalid JSON.
        const auto [is_printable, taken] = first_character(rest);
        const bool is_utf8 = utf8_length(rest) != 0;
        d.source_line += is_printable ? std::string(rest.substr(0, taken))
                         : is_utf8    ? std::string(taken, ' ')
                                      : "?";
        rest.remove_prefix(taken);
    }
    d.caret = static_cast<std::uint32_t>(offset - shown);
    return d;
}

Diagnostic diagnostic_at(Severity severity, InputText where, SourcePlace place, std::string message) {
    const std::size_t offset = offset_of(where.text, place);
    const auto word_end = where.text.find_first_of(" \t\r\n{[(:=,", offset);
    const std::size_t length = std::min(word_end, where.text.size()) - offset;
    return make_diagnostic(severity, where, offset, length, std::move(message));
}

void Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::error) {
        if (full()) return;
        ++errors_;
    } else if (warnings_ == k_max_warnings) {
        if (diagnostic.left_out == 0) return;  // what is not in the picture is named in any case
    } else {
        ++warnings_;
    }
    list_.push_back(std::move(diagnostic));
}

void Diagnostics::error(InputText where, std::size_t offset, std::size_t length, std::string message) {
    if (!full()) add(make_diagnostic(Severity::error, where, offset, length, std::move(message)));
}

void Diagnostics::refuse(InputText where, std::size_t offset, std::size_t length, std::string message) {
    if (full()) return;
    Diagnostic d = make_diagnostic(Severity::error, where, offset, length, std::move(message));
    d.can_skip = true;
    add(std::move(d));
}

void Diagnostics::warn(InputText where, std::size_t offset, std::size_t length, std::string message) {
    if (warnings_ < k_max_warnings)
        add(make_diagnostic(Severity::warning, where, offset, length, std::move(message)));
}

bool Diagnostics::warned(std::string_view key) const {
    // When the list is full, new keys are not stored, or memory would grow with the text.
    return warnings_ == k_max_warnings || std::find(once_.begin(), once_.end(), key) != once_.end();
}

void Diagnostics::warn_once(std::string_view key, InputText where, std::size_t offset, std::size_t length,
                            std::string message) {
    if (warned(key)) return;
    once_.emplace_back(key);
    warn(where, offset, length, std::move(message));
}

std::string item_path(const Diagnostic& d) {
    const auto listed = [&](std::string_view list) { return fmt::format("{}[{}]", list, d.index); };
    switch (d.item) {
        case SceneItem::none:
            return {};
        case SceneItem::camera:
            return "camera";
        case SceneItem::background:
            return "background";
        case SceneItem::setting:
            return "settings";  // the message names it
        case SceneItem::light:
            return listed("lights");
        case SceneItem::material:
            return listed("materials");
        case SceneItem::transform:
            return listed("transforms");
        case SceneItem::shape:
            return listed("shapes");
        case SceneItem::fog:
            return "fog";
        case SceneItem::texture:
            return listed("textures");
    }
    return {};
}

std::string place_text(const Diagnostic& d) {
    if (d.file.empty()) {
        const bool is_listed =
            (d.item >= SceneItem::light && d.item <= SceneItem::shape) || d.item == SceneItem::texture;
        return is_listed ? item_path(d) : std::string();
    }
    return d.line == 0 ? d.file : fmt::format("{}:{}:{}", d.file, d.line, d.column);
}

std::string to_string(const Diagnostic& d) {
    // Names and messages have words of texts and files that may be anybody's.
    std::string out = printable(place_text(d));
    if (!out.empty()) out += ": ";
    out += d.severity == Severity::error     ? "error: "
           : d.severity == Severity::warning ? "warning: "
                                             : "note: ";
    out += printable(d.message);
    out += '\n';
    if (!d.source_line.empty()) {
        // Diagnostics may come from the caller: keep the caret within the line.
        const std::size_t caret = std::min<std::size_t>(d.caret, d.source_line.size());
        const std::size_t most = std::max<std::size_t>(1, d.source_line.size() - caret);
        const std::size_t length = std::clamp<std::size_t>(d.length, 1, most);
        out += fmt::format("  {}\n  {}{}\n", printable(d.source_line), std::string(caret, ' '),
                           '^' + std::string(length - 1, '~'));
    }
    return out;
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::size_t count_warnings(const std::vector<Diagnostic>& diagnostics) {
    return static_cast<std::size_t>(
        std::count_if(diagnostics.begin(), diagnostics.end(),
                      [](const Diagnostic& d) { return d.severity == Severity::warning; }));
}

}  // namespace glint
