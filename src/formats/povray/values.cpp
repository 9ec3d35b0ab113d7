// SPDX-License-Identifier: Apache-2.0
// Values: what #declare and the parameters of macros take.
#include <fmt/format.h>

#include "base/text.h"
#include "formats/povray/extents.h"
#include "formats/povray/value_parser.h"

namespace glint::povray {

std::string_view describe(const Value& value) {
    static constexpr std::string_view k_names[] = {"nothing",     "a number",
                                                   "a string",    "an array",
                                                   "a pigment",   "a finish",
                                                   "a texture",   "a material",
                                                   "an object",   "a camera",
                                                   "a transform", "a macro",
                                                   "a parameter", "a block that glint does not render",
                                                   "a function",  "a spline"};
    if (const auto* numbers = std::get_if<Numbers>(&value)) {
        return numbers->terms == 1 ? "a number" : numbers->is_color() ? "a color" : "a vector";
    }
    return k_names[value.index()];
}

Value ValueParser::value() {
    const Token token = peek();
    if (token.kind == TokenKind::number || token.is('<')) return expression();
    if (begins_string(token)) return string();
    if (token.kind != TokenKind::word) return expression();
    const Deeper deeper(*this);
    if (!deeper.ok) return {};
    if (!Names::is_reserved(token.name)) return identifier_value(token);
    switch (token.word()) {
        case Word::k_array:
            take();
            return array_value(token);
        case Word::k_function:
            take();
            return read_function(token);
        case Word::k_spline:
            take();
            return read_value_spline();
        default:
            break;
    }
    if (begins_number(token) || begins_color(token)) return expression();
    Value other = other_value(token);
    if (!failed() && std::holds_alternative<std::monostate>(other)) expected("a value");
    return other;
}

// A copy of what the identifier stands for, or an expression that begins with it.
Value ValueParser::identifier_value(const Token& name) {
    const Value* value = find_value(name);
    if (value == nullptr) {
        Value other = other_value(name);
        if (!failed() && std::holds_alternative<std::monostate>(other)) {
            error(name,
                  fmt::format("expected a value, found {}{}", quoted(name_of(name.name)), what_is(name)));
        }
        return other;
    }
    if (std::holds_alternative<Numbers>(*value)) return expression();
    if (std::holds_alternative<std::shared_ptr<Array>>(*value)) {
        Value whole = *value;
        take();
        if (!peek().is('[')) return whole;
        const Value element = read_element(name, whole);
        const auto* function = std::get_if<std::shared_ptr<const Function>>(&element);
        if (function != nullptr && peek().is('(')) return expression_after(call_function(name, *function));
        const auto* spline = std::get_if<std::shared_ptr<const ValueSpline>>(&element);
        if (spline != nullptr && peek().is('(')) return expression_after(call_spline(name, *spline));
        const auto* numbers = std::get_if<Numbers>(&element);
        return numbers != nullptr ? expression_after(*numbers) : element;
    }
    const bool is_called = (std::holds_alternative<std::shared_ptr<const Function>>(*value) ||
                            std::holds_alternative<std::shared_ptr<const ValueSpline>>(*value)) &&
                           has_raw() && raw().is('(');
    if (is_called) return expression();
    Value copy = *value;
    take();
    return copy;
}

// The value of an identifier that has been read, also of an element of an array.
Value ValueParser::named_value(const Token& name) {
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) return {};
    const Value* value = find_value(name);
    if (value == nullptr) return {};
    Value whole = *value;
    if (!std::holds_alternative<std::shared_ptr<Array>>(whole) || !peek().is('[')) return whole;
    return read_element(name, whole);
}

// NAME [indices] ), after `(`: whether it is declared.
bool ValueParser::read_defined() {
    const Token name = take_raw();
    if (name.kind != TokenKind::word) {
        error(name, fmt::format("expected a name, found {}", describe(name)));
        return false;
    }
    bool is_defined = Names::is_reserved(name.name);
    if (!is_defined) {
        const Value* found = find_value(name);
        Value value = found != nullptr ? *found : Value();
        if (found != nullptr && peek().is('[')) value = read_element(name, std::move(value));
        is_defined = !failed() && !std::holds_alternative<std::monostate>(value);
    }
    expect(')');
    return is_defined;
}

// A corner of the box around a declared object.
Numbers ValueParser::extent(const Token& function) {
    const auto object = object_argument();
    if (object == nullptr) return {};
    std::string_view why;
    const auto box = extent_of(
        *object, [&](std::uint64_t n) { return spend(n); }, why);
    if (!box) {
        error(function,
              fmt::format("glint does not know {}() of this object: {}", to_string(function.word()), why));
        return {};
    }
    return Numbers(function.word() == Word::k_min_extent ? box->low : box->high);
}

}  // namespace glint::povray
