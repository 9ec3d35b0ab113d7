// SPDX-License-Identifier: Apache-2.0
// What operators apply to, and whole expressions of one or three terms.
#include <fmt/format.h>

#include "base/text.h"
#include "formats/povray/value_parser.h"

namespace glint::povray {

Numbers ValueParser::primary() {
    const Token token = peek();
    if (token.kind == TokenKind::number) {
        take();
        return token.number;
    }
    if (token.is('(')) {
        const Deeper deeper(*this);
        if (!deeper.ok) return {};
        take();
        const Numbers value = full_expression();
        expect(')');
        return value;
    }
    if (token.is('<')) return vector_literal();
    if (token.kind == TokenKind::word) {
        if (!Names::is_reserved(token.name)) return identifier(take());
        if (begins_number(token)) return function(take());
        if (begins_color(token)) return color_value();
    }
    expected("a number");
    return {};
}

// value.x, value.red, ...
Numbers ValueParser::suffixed(Numbers value) {
    while (!failed() && peek().is('.')) {
        take();
        const Token name = take();
        std::size_t i = 0;
        switch (name.word()) {
            case Word::k_x:
            case Word::k_u:
            case Word::k_red:
                i = 0;
                break;
            case Word::k_y:
            case Word::k_v:
            case Word::k_green:
                i = 1;
                break;
            case Word::k_z:
            case Word::k_blue:
                i = 2;
                break;
            case Word::k_t:
            case Word::k_filter:
                i = 3;
                break;
            case Word::k_transmit:
                i = 4;
                break;
            case Word::k_gray:
                value = Numbers(0.297 * value.v[0] + 0.589 * value.v[1] + 0.114 * value.v[2]);
                continue;
            default:
                error(name,
                      fmt::format("expected `x`, `y`, `z`, `red` or another component after `.`, found {}",
                                  describe(name)));
                return value;
        }
        if (static_cast<int>(i) >= value.terms && value.terms > 1) {
            error(name,
                  fmt::format("{} is not a component of a vector of {}", quoted(text_of(name)), value.terms));
        }
        value = Numbers(value.v[i]);
    }
    return value;
}

// <a, b>, up to five numbers; the commas may be missing.
Numbers ValueParser::vector_literal() {
    const Deeper deeper(*this);
    if (!deeper.ok) return {};
    const Token open = take();
    Numbers value;
    int terms = 0;
    while (!failed() && !accept('>')) {
        if (terms == 5) {
            expected("`>` after five numbers");
            break;
        }
        value.v[static_cast<std::size_t>(terms++)] = number();
        accept(',');
    }
    if (!failed() && terms < 2) error(open, "expected two to five numbers between `<` and `>`");
    value.terms = terms;
    return value;
}

Numbers ValueParser::identifier(const Token& name) {
    const Value* found = find_value(name);
    if (found == nullptr) {
        error(name, fmt::format("expected a number, found {}{}", describe(name), what_is(name)));
        return {};
    }
    if (const auto* numbers = std::get_if<Numbers>(found)) return *numbers;
    Value value = *found;
    if (std::holds_alternative<std::shared_ptr<Array>>(value)) {
        value = read_element(name, std::move(value));
        if (failed()) return {};
        if (const auto* numbers = std::get_if<Numbers>(&value)) return *numbers;
    }
    if (const auto* held = std::get_if<std::shared_ptr<const Function>>(&value))
        return call_function(name, *held);
    if (const auto* held = std::get_if<std::shared_ptr<const ValueSpline>>(&value))
        return call_spline(name, *held);
    error(name, fmt::format("expected a number, found {}, {}", describe(name), povray::describe(value)));
    return {};
}

// Whether the token after `skipped` others of this frame ends an expression that began before.
bool ValueParser::is_end_of_number(std::uint32_t skipped) const {
    if (!has_raw(skipped)) return false;
    const Token& next = raw(skipped);
    return next.is(',') || next.is('>') || next.is('}');
}

// An expression of one term.
double ValueParser::number() {
    // Most numbers of large texts, also those below 0.
    if (peek().kind == TokenKind::number && is_end_of_number(0)) return take().number;
    if (peek().is('-') && raw().kind == TokenKind::number && is_end_of_number(1)) {
        take();
        return -take().number;
    }
    const Token at = peek();
    const Numbers value = expression();
    if (value.terms > 1 && !failed()) error(at, "expected a number, found a vector");
    return value.v[0];
}

// An expression of three terms; a single number fills them.
Vec3 ValueParser::vector() {
    const Token at = peek();
    const Numbers value = promoted(expression(), 3);
    if (value.terms > 3 && !failed() && !value.is_color()) error(at, "expected a vector of three numbers");
    return {value.v[0], value.v[1], value.v[2]};
}

double ValueParser::number_or(double value) { return begins_number(peek()) ? number() : value; }

bool ValueParser::flag() { return !is_false(number_or(1)); }

// Whether an expression begins here.
bool ValueParser::begins_number(const Token& token) {
    if (token.kind == TokenKind::number || token.is('(') || token.is('<') || token.is('-') || token.is('+') ||
        token.is('!')) {
        return true;
    }
    if (token.kind != TokenKind::word) return false;
    if (!Names::is_reserved(token.name)) {
        const Value* value = find_value(token);
        if (value == nullptr) return false;
        return std::holds_alternative<Numbers>(*value) ||
               std::holds_alternative<std::shared_ptr<Array>>(*value) ||
               std::holds_alternative<std::shared_ptr<const Function>>(*value) ||
               std::holds_alternative<std::shared_ptr<const ValueSpline>>(*value);
    }
    switch (token.word()) {
#define GLINT_POV_WORD(word) case Word::k_##word:
        GLINT_POV_NUMBER_WORDS(GLINT_POV_WORD)
#undef GLINT_POV_WORD
        case Word::k_version:
            return true;
        default:
            return false;
    }
}

}  // namespace glint::povray
