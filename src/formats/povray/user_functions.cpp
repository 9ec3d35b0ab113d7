// SPDX-License-Identifier: Apache-2.0
// function(PARAMETERS) { expression }, called as a number. As in POV-Ray (measured), numbers that identifiers
// stand for are those of the declaration; comparisons are exact; without parameters they are x, y and z, also
// called u and v.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/reader.h"

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
std::uint32_t Reader::parameter_name(const Token& token) {
    if (token.kind != TokenKind::word) return k_none;
    if (!Names::is_reserved(token.name)) return token.name;
    switch (token.word()) {
        case Word::k_x:
        case Word::k_y:
        case Word::k_z:
        case Word::k_u:
        case Word::k_v: {
            const std::uint32_t name = names_.number_of(fmt::format("parameter {}", to_string(token.word())));
            if (bindings_.size() < names_.size()) bindings_.resize(names_.size());
            return name;
        }
        default:
            return k_none;
    }
}

// After `function`. What is no arithmetic is an error where it is called.
std::shared_ptr<const Function> Reader::read_function(const Token& at) {
    auto out = make_counted<Function>();
    std::vector<std::uint32_t> axes;
    if (accept('(')) {
        while (!failed_ && !accept(')')) {
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
    if (failed_ || !expect('{')) return out;
    Token mark = at;
    mark.kind = TokenKind::symbol;
    mark.symbol = '(';
    out->body.push_back(mark);
    int open = 0;
    while (!failed_ && !(open == 0 && peek().is('}'))) {
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
    if (!failed_) expect('}');
    mark.symbol = ')';
    out->body.push_back(mark);
    mark.kind = TokenKind::end;
    out->body.push_back(mark);
    return out;
}

std::string Reader::what_problem(const Token& token) { return describe(token) + what_is(token); }

// Whether a token is of an expression that glint evaluates; as it is to be read in a call.
bool Reader::take_part(Token& token, const Function& function, const std::vector<std::uint32_t>& axes) {
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
    const Value* value = find_value(token.name);
    if (value == nullptr) return false;
    if (std::holds_alternative<std::shared_ptr<const Function>>(*value)) return true;
    const auto* numbers = std::get_if<Numbers>(value);
    if (numbers == nullptr || numbers->terms > 1) return false;
    token.kind = TokenKind::number;
    token.number = numbers->v[0];
    return true;
}

// The function's name has been read: (NUMBER, ...).
Numbers Reader::call_function(const Token& name, const std::shared_ptr<const Function>& function) {
    const Deeper deeper(*this);
    if (!deeper.ok) return {};
    if (!function->problem.empty()) {
        error(name,
              fmt::format("glint does not evaluate this function of POV-Ray: it has {}", function->problem));
        return {};
    }
    if (frames_.size() >= k_max_frames) {
        error(name, fmt::format("{}(): macros and includes are nested more than {} deep",
                                names_.name(name.name), k_max_frames));
    }
    if (!expect('(')) return {};
    std::vector<double> values;
    while (!failed_ && values.size() < function->parameters.size()) {
        if (peek().is(')')) {
            error(peek(), fmt::format("expected {} values for {}(), found {}", function->parameters.size(),
                                      names_.name(name.name), values.size()));
        }
        values.push_back(number());
        accept(',');
    }
    if (!failed_ && !accept(')')) {
        expected(fmt::format("`)` after the {} values of {}()", values.size(), names_.name(name.name)));
    }
    if (failed_) return {};
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
    return primary();
}

}  // namespace glint::povray
