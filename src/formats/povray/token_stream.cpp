// SPDX-License-Identifier: Apache-2.0
// The stream of tokens: texts and macros within each other.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/token_stream.h"

namespace glint::povray {

// The text's frame, and what the caller declares.
void TokenStream::begin() {
    lex_text(text_.file);
    max_steps_ = k_max_steps + own_tokens().size() + list_bytes_ / k_list_bytes_a_step;
    Frame frame;
    frame.text = text_.file;
    frame.tokens = own_tokens().data();
    frame.end = static_cast<std::uint32_t>(own_tokens().size() - 1);
    frames_.push_back(std::move(frame));
    declare_numbers();
}

void TokenStream::lex_text(std::uint16_t number) {
    LexedText lexed = lex(reading_.texts[number].text, number, names_);
    if (tokens_.size() <= number) {
        tokens_.resize(number + std::size_t{1});
        lex_errors_.resize(number + std::size_t{1});
    }
    tokens_[number] = std::move(lexed.tokens);
    list_bytes_ += lexed.list_bytes;
    lex_errors_[number] = std::move(lexed.error);
    bindings_.resize(names_.size());
}

void TokenStream::set_end() {
    const Frame& frame = frames_.back();
    ahead_ = frame.tokens[std::min(frame.at, frame.end)];
    ahead_.kind = TokenKind::end;
    has_ahead_ = true;
}

bool TokenStream::spend(std::uint64_t steps) {
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

void TokenStream::allow_steps(std::uint64_t shapes) {
    const std::uint64_t most = k_most_steps + own_tokens().size() + list_bytes_ / k_list_bytes_a_step;
    max_steps_ = std::min(max_steps_ + k_steps_per_shape * std::min(shapes, k_most_steps), most);
}

// Counts what the scene holds. Beyond the budget: an error, and false.
bool TokenStream::is_within_memory(const Token& at) {
    reading_.memory.count(reading_.scene);
    if (!reading_.memory.is_exceeded() || failed_) return !failed_;
    return refuse_memory(at);
}

bool TokenStream::has_room(std::uint64_t bytes, const Token& at) {
    if (reading_.memory.has_room(bytes) || failed_) return !failed_;
    return refuse_memory(at);
}

bool TokenStream::refuse_memory(const Token& at) {
    error(at, reading_.memory.message());
    reading_.is_memory_reported = true;
    return false;
}

// The next token of a scene: directives and calls of macros before it are carried out.
void TokenStream::fetch() {
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
            read_directive(token);
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

Token TokenStream::take_raw() {
    Frame& frame = frames_.back();
    if (frame.at >= frame.end) {
        set_end();
        has_ahead_ = false;
        return ahead_;
    }
    spend();
    return frame.tokens[frame.at++];
}

bool TokenStream::list_text(const Token& list, std::string_view& text) {
    text = reading_.texts[list.text].text.substr(list.offset, list.name);
    return spend(list.name / k_list_bytes_a_step);
}

bool TokenStream::expect(char symbol) {
    if (accept(symbol)) return true;
    expected(fmt::format("`{}`", symbol));
    return false;
}

TokenStream::Deeper::Deeper(TokenStream& stream) : stream_(stream) {
    if (++stream.nesting_ <= k_max_depth) return;
    ok = false;
    stream.error(stream.ahead_,
                 fmt::format("blocks, brackets and calls are nested more than {} deep", k_max_depth));
}

bool TokenStream::can_call(const Token& name) {
    if (frames_.size() < k_max_frames) return true;
    error(name, fmt::format("{}(): macros and includes are nested more than {} deep", name_of(name.name),
                            k_max_frames));
    return false;
}

void TokenStream::enter(const Token& name, const std::shared_ptr<const Function>& function,
                        std::span<const double> values) {
    Frame frame;
    frame.kind = FrameKind::macro;
    frame.text = name.text;
    frame.tokens = function->body.data();
    frame.end = static_cast<std::uint32_t>(function->body.size() - 1);
    frame.conditions = conditions_.size();
    frame.call = name;
    frame.function = function;
    frames_.push_back(std::move(frame));
    for (std::size_t i = 0; i < values.size(); ++i)
        bind(function->parameters[i], depth(), Numbers(values[i]));
}

// A value ends before the directives that follow it, so that they see what the value is assigned to.
bool TokenStream::ends_value(Word directive) const {
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

void TokenStream::end_value() {
    marks_.pop_back();
    if (has_ahead_ && ahead_.kind == TokenKind::end) has_ahead_ = false;
}

// Reports what is wrong at the end of the frame's text. False after an error.
bool TokenStream::check_end_of_text() {
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

void TokenStream::leave_frame() {
    for (const std::uint32_t name : frames_.back().locals) bindings_[name].pop_back();
    frames_.pop_back();
}

}  // namespace glint::povray
