// SPDX-License-Identifier: Apache-2.0
// Expressions: numbers, vectors and colors of up to five terms.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/reader.h"
#include "formats/povray_keywords.h"

namespace glint::povray {
namespace {

constexpr double k_greatest = 1e300;

// A number that counts as false in POV-Ray.
bool is_false(double x) { return x <= 1e-10 && x >= -1e-10; }

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

Reader::Deeper::Deeper(Reader& reader) : reader_(reader) {
    if (++reader.nesting_ <= k_max_depth) return;
    ok = false;
    reader.error(reader.ahead_,
                 fmt::format("blocks, brackets and calls are nested more than {} deep", k_max_depth));
}

Numbers Reader::combine(char op, const Token& at, Numbers a, Numbers b) {
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

Numbers Reader::expression() {
    Numbers value = product();
    while (!failed_ && (peek().is('+') || peek().is('-'))) {
        const Token at = take();
        value = combine(at.symbol, at, value, product());
    }
    return value;
}

Numbers Reader::product() {
    Numbers value = factor();
    while (!failed_ && (peek().is('*') || peek().is('/'))) {
        const Token at = take();
        value = combine(at.symbol, at, value, factor());
    }
    return value;
}

Numbers Reader::factor() {
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

// value.x, value.red, ...
Numbers Reader::suffixed(Numbers value) {
    while (!failed_ && peek().is('.')) {
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

Numbers Reader::primary() {
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

// <a, b>, up to five numbers; the commas may be missing.
Numbers Reader::vector_literal() {
    const Deeper deeper(*this);
    if (!deeper.ok) return {};
    const Token open = take();
    Numbers value;
    int terms = 0;
    while (!failed_ && !accept('>')) {
        if (terms == 5) {
            expected("`>` after five numbers");
            break;
        }
        value.v[static_cast<std::size_t>(terms++)] = number();
        accept(',');
    }
    if (!failed_ && terms < 2) error(open, "expected two to five numbers between `<` and `>`");
    value.terms = terms;
    return value;
}

Numbers Reader::identifier(const Token& name) {
    const Value* found = find_value(name.name);
    if (found == nullptr) {
        error(name, fmt::format("expected a number, found {}{}", describe(name), what_is(name)));
        return {};
    }
    if (const auto* numbers = std::get_if<Numbers>(found)) return *numbers;
    Value value = *found;
    if (std::holds_alternative<std::shared_ptr<Array>>(value)) {
        value = read_element(name, std::move(value));
        if (failed_) return {};
        if (const auto* numbers = std::get_if<Numbers>(&value)) return *numbers;
    }
    if (const auto* held = std::get_if<std::shared_ptr<const Function>>(&value))
        return call_function(name, *held);
    error(name, fmt::format("expected a number, found {}, {}", describe(name), povray::describe(value)));
    return {};
}

// With comparisons, and `&` and `|`; only in round brackets.
Numbers Reader::full_expression() {
    Numbers value = comparison();
    while (!failed_ && (peek().is('&') || peek().is('|'))) {
        const bool is_and = take().symbol == '&';
        value = truths(value, comparison(), [&](double a, double b) {
            return is_and ? !is_false(a) && !is_false(b) : !is_false(a) || !is_false(b);
        });
    }
    if (!failed_ && peek().is('?')) {
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

Numbers Reader::comparison() {
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
        if (failed_ || (op != '<' && op != '>' && op != '=' && op != 'l' && op != 'g' && op != 'n'))
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

// Whether the token after `skipped` others of this frame ends an expression that began before.
bool Reader::is_end_of_number(std::uint32_t skipped) const {
    const Frame& frame = frames_.back();
    if (frame.at + skipped >= frame.end) return false;
    const Token& next = frame.tokens[frame.at + skipped];
    return next.is(',') || next.is('>') || next.is('}');
}

// An expression of one term.
double Reader::number() {
    // Most numbers of large texts, also those below 0.
    if (peek().kind == TokenKind::number && is_end_of_number(0)) return take().number;
    if (peek().is('-') && raw().kind == TokenKind::number && is_end_of_number(1)) {
        take();
        return -take().number;
    }
    const Token at = peek();
    const Numbers value = expression();
    if (value.terms > 1 && !failed_) error(at, "expected a number, found a vector");
    return value.v[0];
}

// An expression of three terms; a single number fills them.
Vec3 Reader::vector() {
    const Token at = peek();
    const Numbers value = promoted(expression(), 3);
    if (value.terms > 3 && !failed_ && !value.is_color()) error(at, "expected a vector of three numbers");
    return {value.v[0], value.v[1], value.v[2]};
}

double Reader::number_or(double value) { return begins_number(peek()) ? number() : value; }

bool Reader::flag() { return !is_false(number_or(1)); }

// Whether an expression begins here.
bool Reader::begins_number(const Token& token) {
    if (token.kind == TokenKind::number || token.is('(') || token.is('<') || token.is('-') || token.is('+') ||
        token.is('!')) {
        return true;
    }
    if (token.kind != TokenKind::word) return false;
    if (!Names::is_reserved(token.name)) {
        const Value* value = find_value(token.name);
        if (value == nullptr) return false;
        return std::holds_alternative<Numbers>(*value) ||
               std::holds_alternative<std::shared_ptr<Array>>(*value) ||
               std::holds_alternative<std::shared_ptr<const Function>>(*value);
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

// ", ..." of a word that stands for nothing here.
std::string Reader::what_is(const Token& token) {
    if (token.kind != TokenKind::word) return {};
    if (!Names::is_reserved(token.name)) {
        if (const Value* value = find_value(token.name)) return fmt::format(", {}", povray::describe(*value));
        const std::string_view meaning = povray_meaning(names_.name(token.name));
        if (!meaning.empty()) return fmt::format(" ({} of POV-Ray's that glint does not render)", meaning);
        return ", which is not declared";
    }
    return {};
}

std::string_view describe(const Value& value) {
    static constexpr std::string_view k_names[] = {"nothing",     "a number",
                                                   "a string",    "an array",
                                                   "a pigment",   "a finish",
                                                   "a texture",   "a material",
                                                   "an object",   "a camera",
                                                   "a transform", "a macro",
                                                   "a parameter", "a block that glint does not render",
                                                   "a function"};
    if (const auto* numbers = std::get_if<Numbers>(&value)) {
        return numbers->terms == 1 ? "a number" : numbers->is_color() ? "a color" : "a vector";
    }
    return k_names[value.index()];
}

}  // namespace glint::povray
