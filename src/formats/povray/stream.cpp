// SPDX-License-Identifier: Apache-2.0
// The stream of tokens: texts and macros within each other, and the identifiers of their scopes.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/reader.h"

namespace glint::povray {
namespace {

// Whether an `#end` belongs to the directive.
bool begins_block(Word directive) {
    switch (directive) {
        case Word::k_if:
        case Word::k_ifdef:
        case Word::k_ifndef:
        case Word::k_while:
        case Word::k_for:
        case Word::k_switch:
        case Word::k_macro:
            return true;
        default:
            return false;
    }
}

}  // namespace

void Reader::set_end() {
    const Frame& frame = frames_.back();
    ahead_ = frame.tokens[std::min(frame.at, frame.end)];
    ahead_.kind = TokenKind::end;
    has_ahead_ = true;
}

bool Reader::spend(std::uint64_t steps) {
    const std::uint64_t before = steps_;
    steps_ += steps;
    if (steps_ >> 16 != before >> 16) {
        const Token& at = frames_.front().tokens[frames_.front().at];
        if (!reading_.diagnostics.go_on(text_.place, at.offset)) failed_ = true;
    }
    if (steps_ <= max_steps_ && !reading_.memory.is_exceeded()) return !failed_;
    if (reading_.memory.is_exceeded() && !failed_) {
        const Frame& frame = frames_.back();
        is_within_memory(frame.tokens[std::min(frame.at, frame.end)]);
    }
    if (steps_ > max_steps_ && !failed_) {
        const Frame& frame = frames_.back();
        error(frame.tokens[std::min(frame.at, frame.end)],
              fmt::format(
                  "more than {} tokens were read again for {} shapes: a loop or a macro does not end, or "
                  "computes more than glint follows ({} million tokens, and {} for each shape)",
                  max_steps_, shapes_, k_max_steps / 1'000'000, k_steps_per_shape));
    }
    return !failed_;
}

// A long loop that makes shapes is none that does not end.
void Reader::allow_steps(std::uint64_t shapes) {
    const std::uint64_t most = k_most_steps + tokens_[text_.file].size();
    max_steps_ = std::min(max_steps_ + k_steps_per_shape * std::min(shapes, k_most_steps), most);
}

// Counts what the scene holds. Beyond the budget: an error, and false.
bool Reader::is_within_memory(const Token& at) {
    reading_.memory.count(scene_);
    if (!reading_.memory.is_exceeded() || failed_) return !failed_;
    error(at, reading_.memory.message());
    reading_.is_memory_reported = true;
    return false;
}

// The next token of a scene: directives and calls of macros before it are carried out.
void Reader::fetch() {
    while (!has_ahead_) {
        if (failed_ || !spend()) return set_end();
        Frame& frame = frames_.back();
        if (frame.at >= frame.end) {
            if (is_marked() || !check_end_of_text() || frames_.size() == 1) return set_end();
            leave_frame();
            continue;
        }
        const Token token = frame.tokens[frame.at];
        if (token.kind == TokenKind::directive) {
            if (ends_value(token.directive())) return set_end();
            ++frame.at;
            ahead_ = token;
            read_directive();
            continue;
        }
        ++frame.at;
        if (token.kind == TokenKind::word && !Names::is_reserved(token.name)) {
            const auto& bindings = bindings_[token.name];
            if (!bindings.empty()) {
                if (const auto* macro = std::get_if<std::shared_ptr<const Macro>>(&bindings.back().value)) {
                    const auto kept = *macro;  // the call may declare the macro again
                    call_macro(token, *kept);
                    continue;
                }
            }
        }
        ahead_ = token;
        has_ahead_ = true;
    }
}

// The next token as it is written. Not after peek().
Token Reader::take_raw() {
    Frame& frame = frames_.back();
    if (frame.at >= frame.end) {
        set_end();
        has_ahead_ = false;
        return ahead_;
    }
    spend();
    return frame.tokens[frame.at++];
}

bool Reader::expect(char symbol) {
    if (accept(symbol)) return true;
    expected(fmt::format("`{}`", symbol));
    return false;
}

// A value ends before the directives that follow it, so that they see what the value is assigned to.
bool Reader::ends_value(Word directive) const {
    if (!is_marked()) return false;
    switch (directive) {
        case Word::k_if:
        case Word::k_ifdef:
        case Word::k_ifndef:
        case Word::k_switch:
            return false;
        case Word::k_else:
        case Word::k_elseif:
        case Word::k_end:
        case Word::k_case:
        case Word::k_range:
        case Word::k_break:
            return conditions_.size() == marks_.back().conditions;
        default:
            return true;
    }
}

void Reader::end_value() {
    marks_.pop_back();
    if (has_ahead_ && ahead_.kind == TokenKind::end) has_ahead_ = false;
}

// Reports what is wrong at the end of the frame's text. False after an error.
bool Reader::check_end_of_text() {
    const Frame& frame = frames_.back();
    if (frame.kind != FrameKind::macro) {
        if (const LexError& wrong = lex_errors_[frame.text]; !wrong.message.empty() && !failed_) {
            failed_ = true;
            reading_.diagnostics.error(reading_.texts[frame.text], wrong.offset, wrong.length, wrong.message);
        }
    }
    if (!failed_ && conditions_.size() > frame.conditions) {
        const Token at = conditions_.back().at;
        error(at, fmt::format("this `#{}` has no `#end`", to_string(at.directive())));
    }
    return !failed_;
}

void Reader::leave_frame() {
    for (const std::uint32_t name : frames_.back().locals) bindings_[name].pop_back();
    frames_.pop_back();
}

void Reader::call_macro(const Token& name, const Macro& macro) {
    if (frames_.size() >= k_max_frames) {
        return error(name, fmt::format("{}(): macros and includes are nested more than {} deep",
                                       names_.name(name.name), k_max_frames));
    }
    const Deeper deeper(*this);
    if (!deeper.ok) return;
    CountedVector<Value> values;
    if (!expect('(')) return;
    for (std::size_t i = 0; i < macro.parameters.size() && !failed_; ++i) {
        if (i > 0) accept(',');
        const Token& token = peek();
        if (token.is(')')) {
            return error(token, fmt::format("expected {} values for {}(), found {}", macro.parameters.size(),
                                            names_.name(name.name), i));
        }
        if (token.kind == TokenKind::word && !Names::is_reserved(token.name) && !at_frame_end() &&
            (raw().is(',') || raw().is(')'))) {
            // An identifier alone: the macro may change what it stands for.
            values.emplace_back(target_of({take().name, depth()}));
        } else {
            values.push_back(value());
        }
    }
    if (failed_) return;
    if (!accept(')')) {
        return expected(
            fmt::format("`)` after the {} values of {}()", macro.parameters.size(), names_.name(name.name)));
    }
    frames_.push_back({FrameKind::macro,
                       macro.text,
                       tokens_[macro.text].data(),
                       macro.begin,
                       macro.end,
                       conditions_.size(),
                       {},
                       name,
                       nullptr});
    for (std::size_t i = 0; i < values.size(); ++i) {
        bind(macro.parameters[i], depth(), std::move(values[i]));
    }
}

// Skips to the `#end`, or to the `#else`, `#elseif`, `#case` or `#range`, that belongs to the innermost
// condition; it is the next token.
void Reader::skip_to_branch(bool to_end_only) {
    Frame& frame = frames_.back();
    const Token* const tokens = frame.tokens;
    const std::uint32_t from = frame.at;
    std::size_t open = 0;
    for (; frame.at < frame.end; ++frame.at) {
        const Word word = tokens[frame.at].directive();
        open += begins_block(word) ? 1 : 0;
        switch (word) {
            case Word::k_end:
                if (open == 0) {
                    spend(frame.at - from);
                    return;
                }
                --open;
                break;
            case Word::k_else:
            case Word::k_elseif:
            case Word::k_case:
            case Word::k_range:
                if (open == 0 && !to_end_only) {
                    spend(frame.at - from);
                    return;
                }
                break;
            default:
                break;
        }
    }
    spend(frame.at - from);
    check_end_of_text();
}

// The index of the `#end` that ends what began before token `at`; `end` if there is none.
std::uint32_t Reader::find_end(std::uint32_t at, std::uint32_t end) const {
    const Token* const tokens = frames_.back().tokens;
    std::size_t open = 0;
    for (; at < end; ++at) {
        const Word word = tokens[at].directive();
        open += begins_block(word) ? 1 : 0;
        if (word == Word::k_end && open-- == 0) return at;
    }
    return end;
}

// The binding of a name as a frame sees it. References are followed: `name` becomes that of their target,
// even if it has no binding.
Reader::Binding* Reader::find_binding(std::uint32_t& name, std::uint32_t depth) {
    for (;;) {
        auto& bindings = bindings_[name];
        auto at = bindings.end();
        if (at != bindings.begin() && (at - 1)->depth > depth) {
            at = std::partition_point(bindings.begin(), bindings.end(),
                                      [&](const Binding& binding) { return binding.depth <= depth; });
        }
        if (at == bindings.begin()) return nullptr;
        --at;
        const auto* reference = std::get_if<Reference>(&at->value);
        if (reference == nullptr) return &*at;
        const Reference next = *reference;  // to a frame outside: this ends
        name = next.name;
        depth = next.depth;
    }
}

// The reference that stands for the same without others between: these cannot change while it exists.
Reference Reader::target_of(Reference reference) {
    for (;;) {
        const auto& bindings = bindings_[reference.name];
        const auto after = std::partition_point(bindings.begin(), bindings.end(),
                                                [&](const Binding& b) { return b.depth <= reference.depth; });
        if (after == bindings.begin()) return reference;
        const auto* next = std::get_if<Reference>(&(after - 1)->value);
        if (next == nullptr) return reference;
        reference = *next;
    }
}

const Value* Reader::find_value(std::uint32_t name) {
    const Binding* binding = find_binding(name, depth());
    return binding == nullptr ? nullptr : &binding->value;
}

void Reader::bind(std::uint32_t name, std::uint32_t depth, Value value) {
    auto& bindings = bindings_[name];
    auto at = bindings.end();
    while (at != bindings.begin() && (at - 1)->depth > depth) --at;
    if (at != bindings.begin() && (at - 1)->depth == depth) {
        (at - 1)->value = std::move(value);
        return;
    }
    bindings.insert(at, {depth, std::move(value)});
    if (depth > 0) frames_[depth].locals.push_back(name);
}

// #declare changes what the name stands for here, if anything; else it declares a global identifier.
void Reader::assign(std::uint32_t name, bool is_local, Value value) {
    if (is_local) return bind(name, depth(), std::move(value));
    if (Binding* binding = find_binding(name, depth())) {
        binding->value = std::move(value);
    } else {
        bind(name, 0, std::move(value));
    }
}

void Reader::unbind(std::uint32_t name) {
    if (Binding* binding = find_binding(name, depth())) {
        auto& bindings = bindings_[name];
        const auto at = bindings.begin() + (binding - bindings.data());
        if (at->depth > 0) {
            auto& locals = frames_[at->depth].locals;
            locals.erase(std::find(locals.begin(), locals.end(), name));
        }
        bindings.erase(at);
    }
}

// Messages

std::string_view Reader::text_of(const Token& token) const {
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

std::string Reader::describe(const Token& token) const {
    if (token.kind == TokenKind::end) {
        const auto& tokens = tokens_[token.text];
        const bool is_text_end = token.offset == tokens.back().offset;
        return is_text_end ? "the end of the text" : "the end of the macro or of the value";
    }
    if (token.kind == TokenKind::directive) return fmt::format("`#{}`", text_of(token));
    return quoted(text_of(token));
}

Token Reader::call_place(const Token& at) const {
    for (const Frame& frame : frames_) {
        if (frame.kind == FrameKind::macro) return frame.call;
    }
    return at;
}

void Reader::error(const Token& at, std::string message) {
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

void Reader::warn_once(std::string_view key, const Token& at, std::string message) {
    reading_.diagnostics.warn_once(key, reading_.texts[at.text], at.offset,
                                   std::max<std::size_t>(text_of(at).size(), 1), std::move(message));
}

void Reader::warn(const Token& at, std::string message) {
    reading_.diagnostics.warn(reading_.texts[at.text], at.offset,
                              std::max<std::size_t>(text_of(at).size(), 1), std::move(message));
}

void Reader::expected(std::string_view what) {
    const Token& found = peek();
    if (!failed_) error(found, fmt::format("expected {}, found {}{}", what, describe(found), what_is(found)));
}

}  // namespace glint::povray
