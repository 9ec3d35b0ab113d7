// SPDX-License-Identifier: Apache-2.0
// function(PARAMETERS) { expression }, called as a number. As in POV-Ray (measured), numbers that identifiers
// stand for are those of the declaration; comparisons are exact; without parameters they are x, y and z, also
// called u and v.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/value_parser.h"

namespace glint::povray {
namespace {

constexpr std::string_view k_comparisons = "<>=lgn", k_exact_comparisons = "LGEkhm";

}  // namespace

// The same comparison without tolerance; other symbols as they are.
char exact_comparison(char symbol) {
    const std::size_t at = k_comparisons.find(symbol);
    return at == std::string_view::npos ? symbol : k_exact_comparisons[at];
}

char rough_comparison(char symbol, bool& is_exact) {
    const std::size_t at = k_exact_comparisons.find(symbol);
    is_exact = at != std::string_view::npos;
    return is_exact ? k_comparisons[at] : symbol;
}

// x, y, z, u and v are words of the language: as parameters they have names that no identifier has.
std::uint32_t ValueParser::parameter_name(const Token& token) {
    if (token.kind != TokenKind::word) return k_none;
    if (!Names::is_reserved(token.name)) return token.name;
    switch (token.word()) {
        case Word::k_x:
        case Word::k_y:
        case Word::k_z:
        case Word::k_u:
        case Word::k_v:
            return number_of(fmt::format("parameter {}", to_string(token.word())));
        default:
            return k_none;
    }
}

// After `function`. What is no arithmetic is an error where it is called.
std::shared_ptr<const Function> ValueParser::read_function(const Token& at) {
    auto out = make_counted<Function>();
    std::vector<std::uint32_t> axes;
    if (accept('(')) {
        while (!failed() && !accept(')')) {
            const Token parameter = take();
            if (parameter.kind == TokenKind::end) expected("`)`");
            if (parameter.is(',')) continue;
            out->parameters.push_back(parameter_name(parameter));
            if (out->parameters.back() == k_none) out->problem = what_problem(parameter);
        }
    } else {
        for (const Word axis : {Word::k_x, Word::k_y, Word::k_z, Word::k_u, Word::k_v}) {
            Token token = at;
            token.kind = TokenKind::word;
            token.name = static_cast<std::uint32_t>(axis);
            axes.push_back(parameter_name(token));
        }
        out->parameters.assign(axes.begin(), axes.begin() + 3);
    }
    if (failed() || !expect('{')) return out;
    Token mark = at;
    mark.kind = TokenKind::symbol;
    mark.symbol = '(';
    out->body.push_back(mark);
    int open = 0;
    while (!failed() && !(open == 0 && peek().is('}'))) {
        Token token = take();
        if (token.kind == TokenKind::end) {
            expected("`}`");
            break;
        }
        open += token.is('{') - token.is('}');
        if (!out->problem.empty()) continue;
        if (!take_part(token, *out, axes)) out->problem = what_problem(token);
        out->body.push_back(token);
    }
    if (!failed()) expect('}');
    mark.symbol = ')';
    out->body.push_back(mark);
    mark.kind = TokenKind::end;
    out->body.push_back(mark);
    return out;
}

std::string ValueParser::what_problem(const Token& token) { return describe(token) + what_is(token); }

// Whether a token is of an expression that glint evaluates; as it is to be read in a call.
bool ValueParser::take_part(Token& token, const Function& function, const std::vector<std::uint32_t>& axes) {
    if (token.kind == TokenKind::number) return true;
    if (token.kind == TokenKind::symbol) {
        if (std::string_view("(),+-*/&|<>=lgn").find(token.symbol) == std::string_view::npos) return false;
        token.symbol = exact_comparison(token.symbol);
        return true;
    }
    if (token.kind != TokenKind::word) return false;
    std::uint32_t name = parameter_name(token);
    for (std::size_t i = 3; i < axes.size(); ++i) {
        if (name == axes[i]) name = axes[i - 3];  // u is x, v is y
    }
    const auto& parameters = function.parameters;
    if (name != k_none && std::find(parameters.begin(), parameters.end(), name) != parameters.end()) {
        token.name = name;
        return true;
    }
    if (Names::is_reserved(token.name)) return name == k_none && begins_number(token);
    const Value* value = find_value(token);
    if (value == nullptr) return false;
    if (std::holds_alternative<std::shared_ptr<const Function>>(*value)) return true;
    const auto* numbers = std::get_if<Numbers>(value);
    if (numbers == nullptr || numbers->terms > 1) return false;
    token.kind = TokenKind::number;
    token.number = numbers->v[0];
    return true;
}

// The function's name has been read: (NUMBER, ...).
Numbers ValueParser::call_function(const Token& name, const std::shared_ptr<const Function>& function) {
    const Deeper deeper(*this);
    if (!deeper.ok) return {};
    if (!function->problem.empty()) {
        error(name,
              fmt::format("glint does not evaluate this function of POV-Ray: it has {}", function->problem));
        return {};
    }
    if (!can_call(name) || !expect('(')) return {};
    std::vector<double> values;
    while (!failed() && values.size() < function->parameters.size()) {
        if (peek().is(')')) {
            error(peek(), fmt::format("expected {} values for {}(), found {}", function->parameters.size(),
                                      name_of(name.name), values.size()));
        }
        values.push_back(number());
        accept(',');
    }
    if (!failed() && !accept(')')) {
        expected(fmt::format("`)` after the {} values of {}()", values.size(), name_of(name.name)));
    }
    if (failed()) return {};
    enter(name, function, values);
    return primary();
}

}  // namespace glint::povray
