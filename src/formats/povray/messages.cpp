// SPDX-License-Identifier: Apache-2.0
// Messages: what tokens are called, and where they are.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/token_stream.h"
#include "formats/povray_keywords.h"

namespace glint::povray {

// Messages

std::string_view TokenStream::text_of(const Token& token) const {
    if (token.kind == TokenKind::word) return names_.name(token.name);
    if (token.kind == TokenKind::directive) return to_string(token.directive());
    if (token.kind == TokenKind::end) return {};
    const std::string_view text = reading_.texts[token.text].text;
    if (token.kind == TokenKind::string) return text.substr(token.offset, token.name);
    std::size_t length = 1;
    if (token.kind == TokenKind::number) {
        const auto is_part = [](char c) {
            return (c >= '0' && c <= '9') || c == '.' || c == 'e' || c == 'E';
        };
        while (token.offset + length < text.size() && is_part(text[token.offset + length])) ++length;
    } else if (token.symbol == 'l' || token.symbol == 'g' || token.symbol == 'n') {
        length = 2;
    }
    return text.substr(token.offset, length);
}

std::string TokenStream::describe(const Token& token) const {
    if (token.kind == TokenKind::end) {
        const auto& tokens = tokens_[token.text];
        const bool is_text_end = token.offset == tokens.back().offset;
        return is_text_end ? "the end of the text" : "the end of the macro or of the value";
    }
    if (token.kind == TokenKind::directive) return fmt::format("`#{}`", text_of(token));
    return quoted(text_of(token));
}

// ", ..." of a word that stands for nothing here.
std::string TokenStream::what_is(const Token& token) {
    if (token.kind != TokenKind::word) return {};
    if (!Names::is_reserved(token.name)) {
        if (const Value* value = find_value(token)) return fmt::format(", {}", povray::describe(*value));
        const std::string_view meaning = povray_meaning(names_.name(token.name));
        if (!meaning.empty()) return fmt::format(" ({} of POV-Ray's that glint does not render)", meaning);
        return ", which is not declared";
    }
    return {};
}

Token TokenStream::call_place(const Token& at) const {
    for (const Frame& frame : frames_) {
        if (frame.kind == FrameKind::macro) return frame.call;
    }
    return at;
}

SourcePlace TokenStream::place_of(const Token& token) {
    CountedVector<std::uint32_t>& starts = line_starts_[token.text];
    const std::string_view text = reading_.texts[token.text].text;
    if (starts.empty()) {
        starts.push_back(0);
        for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
            starts.push_back(static_cast<std::uint32_t>(at + 1));
        }
    }
    const auto line = std::upper_bound(starts.begin(), starts.end(), token.offset) - starts.begin();
    const std::uint32_t column = token.offset - starts[static_cast<std::size_t>(line - 1)] + 1;
    return {static_cast<std::uint32_t>(line), static_cast<std::uint16_t>(std::min(column, 65535u)),
            token.text};
}

void TokenStream::error(const Token& at, std::string message) {
    if (failed_) return;
    failed_ = true;
    const Token call = call_place(at);
    if (call.offset != at.offset || call.text != at.text) {
        const InputText where = reading_.texts[call.text];
        const LineColumn place = line_column(where.text, call.offset);
        message += fmt::format(" (in a call of {}() at {}:{}:{})", names_.name(call.name), where.name,
                               place.line, place.column);
    }
    reading_.diagnostics.error(reading_.texts[at.text], at.offset,
                               std::max<std::size_t>(text_of(at).size(), 1), std::move(message));
}

void TokenStream::warn_once(std::string_view key, const Token& at, std::string message) {
    reading_.diagnostics.warn_once(key, reading_.texts[at.text], at.offset,
                                   std::max<std::size_t>(text_of(at).size(), 1), std::move(message));
}

void TokenStream::warn(const Token& at, std::string message) {
    reading_.diagnostics.warn(reading_.texts[at.text], at.offset,
                              std::max<std::size_t>(text_of(at).size(), 1), std::move(message));
}

void TokenStream::expected(std::string_view what) {
    const Token& found = peek();
    if (!failed_) error(found, fmt::format("expected {}, found {}{}", what, describe(found), what_is(found)));
}

}  // namespace glint::povray
