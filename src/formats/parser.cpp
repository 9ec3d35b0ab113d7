// SPDX-License-Identifier: Apache-2.0
#include "formats/parser.h"

#include <fmt/format.h>

#include "base/text.h"

namespace glint {
namespace {

bool opens(const Token& t) { return t.is('{') || t.is('[') || t.is('('); }
bool closes(const Token& t) { return t.is('}') || t.is(']') || t.is(')'); }
char closer(char open) { return open == '{' ? '}' : open == '[' ? ']' : ')'; }

}  // namespace

Parser::Parser(InputText place, Dialect dialect, Diagnostics& diagnostics)
    : place_(place), diagnostics_(diagnostics), tokenizer_(place.text, dialect) {
    if (place.text.starts_with("\xff\xfe") || place.text.starts_with("\xfe\xff")) {
        error({}, "expected UTF-8, found UTF-16");
        stop();
    } else {
        advance();
    }
}

void Parser::report_progress() {
    constexpr std::uint32_t k_tokens = 4096;
    until_report_ = k_tokens;
    if (!diagnostics_.go_on(place_, token_.offset)) stop();
}

void Parser::advance() {
    if (until_report_-- == 0) report_progress();
    if (stopped_) return;
    token_ = tokenizer_.next();
    is_token_reported_ = token_.kind == TokenKind::open_string;
    switch (token_.kind) {
        case TokenKind::open_string:
            error(token_, "expected a closing quote before the end of the line");
            token_.kind = TokenKind::string;
            break;
        case TokenKind::open_comment:
            error(token_, "expected `*/`: the comment has no end");
            stop();
            break;
        case TokenKind::bad_byte:
            error(token_, fmt::format("expected text, found the byte 0x{:02x}",
                                      static_cast<unsigned char>(place_.text[token_.offset])));
            stop();
            break;
        default:
            break;
    }
}

bool Parser::at_closing_bracket() const { return closes(token_); }

Token Parser::take() {
    const Token taken = token_;
    if (!at_end()) advance();
    return taken;
}

Token Parser::peek() const {
    Tokenizer ahead = tokenizer_;
    return ahead.next();
}

std::string Parser::name(const Token& token) const {
    return token.kind == TokenKind::string ? string_value(text(token)) : std::string(text(token));
}

bool Parser::accept(char symbol) {
    if (!token_.is(symbol)) return false;
    advance();
    return true;
}

bool Parser::expect(char symbol) {
    if (accept(symbol)) return true;
    expected(fmt::format("`{}`", symbol));
    return false;
}

void Parser::expected(std::string_view what) {
    if (is_token_reported_) return;
    error(token_, fmt::format("expected {}, found {}{}", what, describe(token_),
                              refuse_code_ && looks_like_code() ? ": glint reads data, not code" : ""));
}

bool Parser::looks_like_code() const {
    constexpr std::string_view operators = ".(+-*/%?<>=`&|!";
    if (token_.kind == TokenKind::symbol) return operators.find(token_.symbol) != std::string_view::npos;
    if (token_.kind != TokenKind::word) return false;
    const Token after = peek();
    return after.kind == TokenKind::symbol && operators.find(after.symbol) != std::string_view::npos;
}

void Parser::error(const Token& token, std::string message) {
    if (stopped_) return;
    diagnostics_.error(place_, token.offset, token.length, std::move(message));
    if (diagnostics_.full()) stop();
}

void Parser::warn(const Token& token, std::string message) {
    if (!stopped_) diagnostics_.warn(place_, token.offset, token.length, std::move(message));
}

void Parser::note(const Token& token, std::string message) {
    if (!stopped_)
        diagnostics_.add(
            make_diagnostic(Severity::note, place_, token.offset, token.length, std::move(message)));
}

void Parser::warn_ignored(std::string_view name, const Token& at, std::string_view owner,
                          std::span<const std::string_view> known) {
    // A text may have millions of unknown names: a repeated warning is skipped before its message is
    // formatted.
    const std::string once = fmt::format("{}.{}", owner, name);
    if (stopped_ || diagnostics_.warned(once)) return;
    const std::string of = owner.empty() ? std::string() : fmt::format(" of a {}", owner);
    diagnostics_.warn_once(once, place_, at.offset, at.length,
                           fmt::format("glint ignores {}{}{}", quoted(name), of, did_you_mean(name, known)));
}

std::string Parser::describe(const Token& token) const {
    if (token.kind == TokenKind::end) return "the end of the text";
    return quoted(text(token));
}

void Parser::stop() {
    stopped_ = true;
    tokenizer_.stop();
    const std::size_t end = place_.text.size();
    token_ = Token{.line = token_.line, .column = token_.column, .offset = end};
}

bool Parser::number(double& value, const Range& range) {
    if (token_.kind != TokenKind::number) {
        expected("a number");
        return false;
    }
    value = token_.number;
    if (!(value >= -1.7976931348623157e308 && value <= 1.7976931348623157e308)) {
        error(token_, fmt::format("number out of range: {} (doubles end at 1.8e308)", quoted(text(token_))));
    } else if (!range.contains(value)) {
        expected(range.text);
    }
    advance();
    return true;
}

bool Parser::numbers(std::span<double> values, const Range& range, char open, char close) {
    static constexpr std::string_view counts[] = {"no numbers", "one number", "two numbers", "three numbers",
                                                  "four numbers"};
    const std::string_view count = counts[values.size()];
    if (!token_.is(open)) {
        expected(fmt::format("`{}` and {}", open, count));
        return false;
    }
    advance();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool begun = i == 0 || accept(',');
        if (begun && number(values[i], range)) continue;
        if (!begun) expected(fmt::format("`,` and {} in all", count));
        skip_to_close(close);
        return true;
    }
    accept(',');
    if (!accept(close)) {
        expected(fmt::format("`{}` after {}", close, count));
        skip_to_close(close);
    }
    return true;
}

bool Parser::triple(double (&values)[3], const Range& range, char open, char close) {
    return numbers(values, range, open, close);
}

bool Parser::point(Vec3& value, const Range& range, char open, char close) {
    double v[3] = {};
    if (!triple(v, range, open, close)) return false;
    value = {v[0], v[1], v[2]};
    return true;
}

bool Parser::choice(std::span<const std::string_view> words, std::string_view what, int& index) {
    if (token_.kind != TokenKind::word && token_.kind != TokenKind::string) {
        expected(what);
        return false;
    }
    const std::string word = name(token_);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (word != words[i]) continue;
        index = static_cast<int>(i);
        advance();
        return true;
    }
    error(token_, fmt::format("expected {}, found {}{}", what, describe(token_), did_you_mean(word, words)));
    return false;
}

int Parser::field(FieldSet& set, const Token& key, std::string_view key_name) {
    const auto fields = set.fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].name != key_name) continue;
        const int index = static_cast<int>(i);
        if (set.has(index) && !fields[i].repeats) {
            warn(key, fmt::format("`{}` is given twice in one {}: the last one holds", key_name, set.what()));
        }
        set.add(index);
        return index;
    }
    report_unknown(set, key, key_name);
    return -1;
}

void Parser::report_unknown(const FieldSet& set, const Token& key, std::string_view key_name) {
    const auto fields = set.fields();
    std::array<std::string_view, k_max_keys> names;
    for (std::size_t i = 0; i < fields.size(); ++i) names[i] = fields[i].name;
    const auto known = std::span(names).first(fields.size());
    if (!set.is_strict()) return warn_ignored(key_name, key, set.what(), known);
    for (const SpellingHint& hint : set.hints()) {
        if (hint.name == key_name)
            return error(key, fmt::format("{} has no {}: write {}", with_article(set.what()),
                                          quoted(key_name), hint.instead));
    }
    error(key, fmt::format("{} has no {}{}", with_article(set.what()), quoted(key_name),
                           did_you_mean(key_name, known)));
}

bool Parser::check_required(const FieldSet& set, const Token& block) {
    std::string missing;
    const auto fields = set.fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (!fields[i].required || set.has(static_cast<int>(i))) continue;
        missing += fmt::format("{}`{}`", missing.empty() ? "" : ", ", fields[i].name);
    }
    if (missing.empty()) return true;
    error(block, fmt::format("expected {} in the {}", missing, set.what()));
    return false;
}

bool Parser::skip_value() {
    if (closes(token_) || at_end()) {
        expected("a value");
        return false;
    }
    std::array<char, k_max_nesting> closers;
    int depth = 0;
    do {
        if (at_end()) {
            expected(fmt::format("`{}`", closers[depth - 1]));
            return false;
        }
        const Token token = take();
        if (opens(token)) {
            if (depth == k_max_nesting) {
                stop_at_nesting(token);
                return false;
            }
            closers[depth++] = closer(token.symbol);
        } else if (closes(token) && !token.is(closers[--depth])) {
            error(token, fmt::format("expected `{}`, found '{}'", closers[depth], token.symbol));
            return false;
        }
    } while (depth > 0);
    return true;
}

void Parser::skip_to_close(char close) {
    skip_until([](const Token& t) { return closes(t); });
    accept(close);
}

void Parser::skip_to_separator() {
    skip_until([](const Token& t) { return t.is(',') || closes(t); });
}

// Stops at the first such token outside nested brackets.
template <class IsEnd> void Parser::skip_until(IsEnd&& is_end) {
    for (int depth = 0; !at_end();) {
        if (depth == 0 && is_end(token_)) return;
        const Token token = take();
        if (opens(token) && ++depth > k_max_nesting) return stop_at_nesting(token);
        if (closes(token)) --depth;
    }
}

void Parser::stop_at_nesting(const Token& token) {
    error(token, fmt::format("brackets are nested more than {} deep", k_max_nesting));
    stop();
}

}  // namespace glint
