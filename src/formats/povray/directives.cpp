// SPDX-License-Identifier: Apache-2.0
// Directives: declarations, conditions, loops, messages.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/reader.h"

namespace glint::povray {

// The directive is in ahead_.
void Reader::read_directive() {
    const Token at = ahead_;
    const Deeper deeper(*this);
    if (!deeper.ok) return;
    switch (at.directive()) {
        case Word::k_declare:
        case Word::k_local:
            return read_declare(at.directive() == Word::k_local);
        case Word::k_macro:
            return read_macro(at);
        case Word::k_if:
            return read_if(at, condition());
        case Word::k_ifdef:
        case Word::k_ifndef:
            return read_ifdef(at, at.directive() == Word::k_ifdef);
        case Word::k_else:
            return read_else(at);
        case Word::k_elseif:
            return read_elseif(at);
        case Word::k_end:
            return read_end(at);
        case Word::k_while:
            conditions_.push_back({ConditionKind::loop_while, at, false, frames_.back().at});
            return run_while();
        case Word::k_for:
            return read_for(at);
        case Word::k_switch:
            return read_switch(at);
        case Word::k_case:
        case Word::k_range:
            return read_case(at);
        case Word::k_break:
            return read_break(at);
        case Word::k_include:
            return read_include(at);
        case Word::k_version:
            version_place_ = at;
            return read_version();
        case Word::k_default:
            return read_default();
        case Word::k_undef:
            return unbind(take_raw().name);
        case Word::k_error:
        case Word::k_warning:
        case Word::k_debug:
        case Word::k_render:
        case Word::k_statistics:
            return read_message(at);
        default:
            error(at, fmt::format("`#{}` (files of its own) is of POV-Ray's language; glint does not read or "
                                  "write other files",
                                  to_string(at.directive())));
    }
}

// NAME [indices] = VALUE [;]
void Reader::read_declare(bool is_local) {
    const Token name = take_raw();
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) {
        const bool is_word = name.kind == TokenKind::word;
        return error(name, fmt::format("expected a name to declare, found {}{}", describe(name),
                                       is_word ? ", a word of the language" : ""));
    }
    begin_value();
    if (peek().is('[')) {
        std::uint32_t target = name.name;
        Binding* binding = find_binding(target, depth());
        auto* array = binding ? std::get_if<std::shared_ptr<Array>>(&binding->value) : nullptr;
        if (array == nullptr) {
            error(name, fmt::format("{} is not an array", quoted(names_.name(name.name))));
        } else {
            const std::shared_ptr<Array> kept = *array;  // its elements stay where they are
            std::vector<std::uint32_t> indices;
            while (!failed_ && peek().is('[')) indices.push_back(index());
            if (!failed_ && expect('=')) {
                Value assigned = value();
                binding = failed_ ? nullptr : find_binding(target = name.name, depth());
                if (binding) assign_element(name, *binding, indices, std::move(assigned));
            }
        }
    } else if (expect('=')) {
        Value assigned = value();
        if (!failed_) assign(name.name, is_local, std::move(assigned));
    }
    if (!failed_) accept(';');
    end_value();
}

// NAME (PARAMETERS) tokens #end. The body is parsed at each call.
void Reader::read_macro(const Token& at) {
    const Token name = take_raw();
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) {
        return error(name, fmt::format("expected the name of a macro, found {}", describe(name)));
    }
    Token token = take_raw();
    if (!token.is('(')) return error(token, fmt::format("expected `(`, found {}", describe(token)));
    auto macro = std::make_shared<Macro>();
    for (token = take_raw(); !token.is(')'); token = take_raw()) {
        if (token.is(',')) continue;
        if (token.kind != TokenKind::word || Names::is_reserved(token.name)) {
            return error(token,
                         fmt::format("expected the name of a parameter or `)`, found {}{}", describe(token),
                                     token.kind == TokenKind::word ? ", a word of the language" : ""));
        }
        macro->parameters.push_back(token.name);
    }
    Frame& frame = frames_.back();
    macro->text = frame.text;
    macro->begin = frame.at;
    macro->end = find_end(frame.at, frame.end);
    spend(macro->end - macro->begin);
    if (macro->end >= frame.end) return error(at, "this `#macro` has no `#end`");
    frame.at = macro->end + 1;
    assign(name.name, false, std::shared_ptr<const Macro>(std::move(macro)));
}

// ( full expression )
bool Reader::condition() {
    if (!expect('(')) return false;
    const Numbers value = full_expression();
    expect(')');
    // POV-Ray's limit for a number that counts as 0.
    return !failed_ && !(value.v[0] < 1e-10 && value.v[0] > -1e-10);
}

void Reader::read_if(const Token& at, bool is_true) {
    if (failed_) return;
    conditions_.push_back({ConditionKind::branch, at, is_true});
    if (!is_true) skip_to_branch(false);
}

void Reader::read_ifdef(const Token& at, bool wanted) {
    if (const Token open = take_raw(); !open.is('(')) {
        return error(open, fmt::format("expected `(`, found {}", describe(open)));
    }
    const bool is_defined = read_defined();
    if (!failed_) read_if(at, is_defined == wanted);
}

// NAME [indices] ), after `(`: whether it is declared.
bool Reader::read_defined() {
    const Token name = take_raw();
    if (name.kind != TokenKind::word) {
        error(name, fmt::format("expected a name, found {}", describe(name)));
        return false;
    }
    bool is_defined = Names::is_reserved(name.name);
    if (!is_defined) {
        const Value* found = find_value(name.name);
        is_defined = found != nullptr && !std::holds_alternative<std::monostate>(*found);
        if (found != nullptr && peek().is('[')) {
            Value element_of = *found;
            const Value* element = read_element(name, element_of);
            is_defined = element != nullptr && !std::holds_alternative<std::monostate>(*element);
        }
    }
    expect(')');
    return is_defined;
}

void Reader::read_else(const Token& at) {
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

void Reader::read_elseif(const Token& at) {
    if (conditions_.size() <= frames_.back().conditions || conditions_.back().kind != ConditionKind::branch) {
        return error(at, "this `#elseif` has no `#if`");
    }
    if (conditions_.back().is_done) return skip_to_branch(true);
    const bool is_true = condition();
    if (failed_) return;
    conditions_.back().is_done = is_true;
    if (!is_true) skip_to_branch(false);
}

void Reader::read_end(const Token& at) {
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
void Reader::run_while() {
    if (condition() || failed_) return;
    skip_to_branch(true);
    leave_condition();
}

// After skip_to_branch(true).
void Reader::leave_condition() {
    if (failed_) return;
    ++frames_.back().at;
    conditions_.pop_back();
}

bool Reader::is_within(double value, const Condition& condition) const {
    // POV-Ray's tolerance.
    return condition.step > 0 ? value <= condition.end + 1e-10 : value >= condition.end - 1e-10;
}

// (NAME, from, to [, step])
void Reader::read_for(const Token& at) {
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
    conditions_.push_back(std::move(loop));
    if (is_run) return;
    skip_to_branch(true);
    leave_condition();
}

void Reader::read_switch(const Token& at) {
    if (!expect('(')) return;
    const double value = number();
    if (!expect(')')) return;
    Condition choice{ConditionKind::choice, at};
    choice.choice = value;
    conditions_.push_back(std::move(choice));
    skip_to_branch(false);
}

// #case (value), #range (from, to): read where the choice is open, and ignored after it has been made.
void Reader::read_case(const Token& at) {
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
void Reader::read_break(const Token& at) {
    const std::size_t first = frames_.back().conditions;
    std::size_t i = conditions_.size();
    while (i > first && conditions_[i - 1].kind == ConditionKind::branch) --i;
    if (i == first) return error(at, "this `#break` is in no loop and no `#switch`");
    while (conditions_.size() >= i && !failed_) {
        skip_to_branch(true);
        leave_condition();
    }
}

void Reader::read_version() {
    if (peek().kind == TokenKind::word && peek().word() == Word::k_version) {
        take();  // #version version;
    } else {
        begin_value();
        const double version = number();
        if (!failed_) version_ = version;
        end_value();
    }
    accept(';');
}

// #default { items }
void Reader::read_default() {
    if (!expect('{')) return;
    while (!failed_ && !accept('}')) {
        const Token item = take();
        switch (item.word()) {
            case Word::k_texture:
                default_texture_ = read_texture();
                break;
            case Word::k_pigment:
                read_pigment(default_texture_.pigment);
                break;
            case Word::k_finish:
                read_finish(default_texture_.finish);
                break;
            case Word::k_normal:
                read_opaque(Word::k_normal, item);
                default_texture_.missing = missing(item, "normal");
                break;
            case Word::k_camera:
                camera_default_ = read_camera(item);
                break;
            default:
                return error(item,
                             fmt::format("expected `texture`, `pigment`, `finish`, `normal`, `camera` or "
                                         "`}}`, found {}",
                                         describe(item)));
        }
    }
    default_shared_ = std::make_shared<Texture>(default_texture_);
}

void Reader::read_message(const Token& at) {
    begin_value();
    const std::string text = string();
    accept(';');
    end_value();
    if (failed_) return;
    if (at.directive() == Word::k_error) {
        error(at, fmt::format("the text reports an error: {}", quoted(text)));
    } else if (at.directive() == Word::k_warning) {
        warn(at, fmt::format("the text warns: {}", quoted(text)));
    }
}

}  // namespace glint::povray
