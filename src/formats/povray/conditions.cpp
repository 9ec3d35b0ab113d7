// SPDX-License-Identifier: Apache-2.0
// The directives that choose what is read: conditions and loops.
#include <fmt/format.h>

#include "formats/povray/directive_parser.h"

namespace glint::povray {
namespace {

bool is_within(double value, const Condition& condition) {
    // POV-Ray's tolerance.
    return condition.step > 0 ? value <= condition.end + 1e-10 : value >= condition.end - 1e-10;
}

}  // namespace

bool DirectiveParser::begins_block(Word directive) {
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

// ( full expression )
bool DirectiveParser::condition() {
    if (!expect('(')) return false;
    const Numbers value = full_expression();
    expect(')');
    // POV-Ray's limit for a number that counts as 0.
    return !failed() && !(value.v[0] < 1e-10 && value.v[0] > -1e-10);
}

void DirectiveParser::read_if(const Token& at, bool is_true) {
    if (failed()) return;
    conditions_.push_back({ConditionKind::branch, at, is_true});
    if (!is_true) skip_to_branch(false);
}

void DirectiveParser::read_ifdef(const Token& at, bool wanted) {
    if (const Token open = take_raw(); !open.is('(')) {
        return error(open, fmt::format("expected `(`, found {}", describe(open)));
    }
    const bool is_defined = read_defined();
    if (!failed()) read_if(at, is_defined == wanted);
}

void DirectiveParser::read_else(const Token& at) {
    if (conditions_.size() <= frames_.back().conditions ||
        (conditions_.back().kind != ConditionKind::branch &&
         conditions_.back().kind != ConditionKind::choice)) {
        return error(at, "this `#else` has no `#if`");
    }
    Condition& condition = conditions_.back();
    if (condition.is_done) {
        skip_to_branch(true);
    } else {
        condition.is_done = true;
    }
}

void DirectiveParser::read_elseif(const Token& at) {
    if (conditions_.size() <= frames_.back().conditions || conditions_.back().kind != ConditionKind::branch) {
        return error(at, "this `#elseif` has no `#if`");
    }
    if (conditions_.back().is_done) return skip_to_branch(true);
    const bool is_true = condition();
    if (failed()) return;
    conditions_.back().is_done = is_true;
    if (!is_true) skip_to_branch(false);
}

void DirectiveParser::read_end(const Token& at) {
    if (conditions_.size() <= frames_.back().conditions) {
        return error(at, "this `#end` has nothing to end");
    }
    Condition& condition = conditions_.back();
    if (condition.kind == ConditionKind::loop_while) {
        frames_.back().at = condition.begin;
        return run_while();
    }
    if (condition.kind == ConditionKind::loop_for) {
        Binding* binding = find_binding(condition.name, depth());
        auto* counter = binding ? std::get_if<Numbers>(&binding->value) : nullptr;
        if (counter == nullptr) return error(at, "the variable of this `#for` is no longer a number");
        *counter = counter->v[0] + condition.step;
        if (is_within(counter->v[0], condition)) {
            frames_.back().at = condition.begin;
            return;
        }
    }
    conditions_.pop_back();
}

// The condition of the innermost #while is next.
void DirectiveParser::run_while() {
    if (condition() || failed()) return;
    skip_to_branch(true);
    leave_condition();
}

// After skip_to_branch(true).
void DirectiveParser::leave_condition() {
    if (failed()) return;
    ++frames_.back().at;
    conditions_.pop_back();
}

// (NAME, from, to [, step])
void DirectiveParser::read_for(const Token& at) {
    if (!expect('(')) return;
    const Token name = take_raw();
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) {
        return error(name, fmt::format("expected a name, found {}", describe(name)));
    }
    accept(',');
    const double from = number();
    accept(',');
    Condition loop{ConditionKind::loop_for, at};
    loop.end = number();
    if (accept(',')) loop.step = number();
    if (!expect(')')) return;
    if (loop.step == 0) return error(at, "expected a step other than 0");
    loop.name = name.name;
    loop.begin = frames_.back().at;
    bind(name.name, depth(), Numbers(from));
    const bool is_run = is_within(from, loop);
    conditions_.push_back(loop);
    if (is_run) return;
    skip_to_branch(true);
    leave_condition();
}

void DirectiveParser::read_switch(const Token& at) {
    if (!expect('(')) return;
    const double value = number();
    if (!expect(')')) return;
    Condition choice{ConditionKind::choice, at};
    choice.choice = value;
    conditions_.push_back(choice);
    skip_to_branch(false);
}

// #case (value), #range (from, to): read where the choice is open, and ignored after it has been made.
void DirectiveParser::read_case(const Token& at) {
    if (conditions_.size() <= frames_.back().conditions || conditions_.back().kind != ConditionKind::choice) {
        return error(at, fmt::format("this `#{}` has no `#switch`", to_string(at.directive())));
    }
    if (!expect('(')) return;
    const double from = number();
    double to = from;
    if (at.directive() == Word::k_range) {
        accept(',');
        to = number();
    }
    if (!expect(')')) return;
    Condition& choice = conditions_.back();
    if (choice.is_done) return;
    choice.is_done = choice.choice >= from - 1e-10 && choice.choice <= to + 1e-10;
    if (!choice.is_done) skip_to_branch(false);
}

// Leaves the innermost loop or #switch of this text.
void DirectiveParser::read_break(const Token& at) {
    const std::size_t first = frames_.back().conditions;
    std::size_t i = conditions_.size();
    while (i > first && conditions_[i - 1].kind == ConditionKind::branch) --i;
    if (i == first) return error(at, "this `#break` is in no loop and no `#switch`");
    while (conditions_.size() >= i && !failed()) {
        skip_to_branch(true);
        leave_condition();
    }
}

// Skips to the `#end`, or to the `#else`, `#elseif`, `#case` or `#range`, that belongs to the innermost
// condition; it is the next token.
void DirectiveParser::skip_to_branch(bool to_end_only) {
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
std::uint32_t DirectiveParser::find_end(std::uint32_t at, std::uint32_t end) const {
    const Token* const tokens = frames_.back().tokens;
    std::size_t open = 0;
    for (; at < end; ++at) {
        const Word word = tokens[at].directive();
        open += begins_block(word) ? 1 : 0;
        if (word == Word::k_end && open-- == 0) return at;
    }
    return end;
}

}  // namespace glint::povray
