// SPDX-License-Identifier: Apache-2.0
// Expressions: the operators on numbers, vectors and colors of up to five terms.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/value_parser.h"

namespace glint::povray {
namespace {

constexpr double k_greatest = 1e300;

// Each term of two values by `use`, as 1 or 0.
template <class Use> Numbers truths(Numbers a, Numbers b, Use use) {
    const int terms = std::max(a.terms, b.terms);
    a = promoted(a, terms);
    b = promoted(b, terms);
    for (std::size_t i = 0; i < static_cast<std::size_t>(terms); ++i) a.v[i] = use(a.v[i], b.v[i]) ? 1 : 0;
    return a;
}

}  // namespace

Numbers promoted(const Numbers& value, int terms) {
    if (value.terms >= terms) return value;
    Numbers out = value;
    if (value.terms == 1) out.v.fill(value.v[0]);
    for (int i = terms; i < 5; ++i) out.v[static_cast<std::size_t>(i)] = 0;
    out.terms = terms;
    return out;
}

Numbers ValueParser::combine(char op, const Token& at, Numbers a, Numbers b) {
    const int terms = std::max(a.terms, b.terms);
    a = promoted(a, terms);
    b = promoted(b, terms);
    for (std::size_t i = 0; i < static_cast<std::size_t>(terms); ++i) {
        switch (op) {
            case '+':
                a.v[i] += b.v[i];
                break;
            case '-':
                a.v[i] -= b.v[i];
                break;
            case '*':
                a.v[i] *= b.v[i];
                break;
            default:
                // Divided by 0, anything is POV-Ray's greatest number (measured: also -1 and 0). But terms of
                // a vector that are 0 / 0 are those that no scene uses: a filter, a transmit.
                if (b.v[i] != 0) {
                    a.v[i] /= b.v[i];
                } else if (terms == 1 || a.v[i] != 0) {
                    a.v[i] = k_greatest;
                }
        }
        if (!(a.v[i] <= k_greatest && a.v[i] >= -k_greatest)) {
            error(at, "the result is not a finite number below 1e300");
            return Numbers();
        }
    }
    return a;
}

Numbers ValueParser::expression() {
    Numbers value = product();
    while (!failed() && (peek().is('+') || peek().is('-'))) {
        const Token at = take();
        value = combine(at.symbol, at, value, product());
    }
    return value;
}

Numbers ValueParser::product() {
    Numbers value = factor();
    while (!failed() && (peek().is('*') || peek().is('/'))) {
        const Token at = take();
        value = combine(at.symbol, at, value, factor());
    }
    return value;
}

Numbers ValueParser::factor() {
    if (peek().is('-') || peek().is('+') || peek().is('!')) {
        const Deeper deeper(*this);
        if (!deeper.ok) return {};
        const char sign = take().symbol;
        Numbers value = factor();
        for (double& x : value.v) x = sign == '!' ? (is_false(x) ? 1.0 : 0.0) : sign == '-' ? -x : x;
        return value;
    }
    return suffixed(primary());
}

// The rest of an expression whose first operand has been read.
Numbers ValueParser::expression_after(Numbers first) {
    first = suffixed(first);
    while (!failed() && (peek().is('*') || peek().is('/'))) {
        const Token at = take();
        first = combine(at.symbol, at, first, factor());
    }
    while (!failed() && (peek().is('+') || peek().is('-'))) {
        const Token at = take();
        first = combine(at.symbol, at, first, product());
    }
    return first;
}

// With comparisons, and `&` and `|`; only in round brackets.
Numbers ValueParser::full_expression() {
    Numbers value = comparison();
    while (!failed() && (peek().is('&') || peek().is('|'))) {
        const bool is_and = take().symbol == '&';
        value = truths(value, comparison(), [&](double a, double b) {
            return is_and ? !is_false(a) && !is_false(b) : !is_false(a) || !is_false(b);
        });
    }
    if (!failed() && peek().is('?')) {
        const Deeper deeper(*this);
        if (!deeper.ok) return {};
        take();
        const Numbers yes = full_expression();
        expect(':');
        const Numbers no = full_expression();
        value = is_false(value.v[0]) ? no : yes;
    }
    return value;
}

Numbers ValueParser::comparison() {
    if (begins_string(peek())) {
        const String a = string();
        const Token op = take();
        const String b = string();
        const int order = compare(*a, *b);
        switch (op.kind == TokenKind::symbol ? op.symbol : '\0') {
            case '=':
                return order == 0;
            case 'n':
                return order != 0;
            case '<':
                return order < 0;
            case '>':
                return order > 0;
            case 'l':
                return order <= 0;
            case 'g':
                return order >= 0;
            default:
                error(op, fmt::format("expected a comparison, found {}", describe(op)));
                return {};
        }
    }
    Numbers value = expression();
    for (;;) {
        bool is_exact = false;
        const char op = peek().kind == TokenKind::symbol ? rough_comparison(peek().symbol, is_exact) : '\0';
        if (failed() || (op != '<' && op != '>' && op != '=' && op != 'l' && op != 'g' && op != 'n'))
            return value;
        take();
        // Numbers that are equal but for 1e-10 are still less or greater (POV-Ray, measured).
        value = truths(value, expression(), [&](double a, double b) {
            const bool is_equal = is_exact ? a == b : is_false(a - b);
            return op == '<'   ? a < b
                   : op == '>' ? a > b
                   : op == '=' ? is_equal
                   : op == 'n' ? !is_equal
                   : op == 'l' ? a < b || is_equal
                               : a > b || is_equal;
        });
    }
}

}  // namespace glint::povray
