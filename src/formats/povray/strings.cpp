// SPDX-License-Identifier: Apache-2.0
// Strings: names of includes, messages, and what is computed from them.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/number_text.h"
#include "formats/povray/value_parser.h"

namespace glint::povray {
namespace {

// C's "%length.decimalsf"; a negative length means leading zeros, negative decimals mean six.
std::string format_number(double value, double length, double decimals) {
    const int width = static_cast<int>(std::clamp(length < 0 ? -length : length, 0.0, 300.0));
    const int places = decimals < 0 ? 6 : static_cast<int>(std::clamp(decimals, 0.0, 100.0));
    if (length < 0) return fmt::format("{:0{}.{}f}", value, width, places);
    return fmt::format("{:{}.{}f}", value, width, places);
}

}  // namespace

bool ValueParser::begins_string(const Token& token) {
    if (token.kind == TokenKind::string) return true;
    if (token.kind != TokenKind::word) return false;
    switch (token.word()) {
#define GLINT_POV_WORD(word) case Word::k_##word:
        GLINT_POV_STRING_WORDS(GLINT_POV_WORD)
#undef GLINT_POV_WORD
        return true;
        default:
            break;
    }
    if (Names::is_reserved(token.name)) return false;
    const Value* value = find_value(token);
    return value != nullptr && std::holds_alternative<String>(*value);
}

// Never null.
String ValueParser::string() {
    static const String empty = std::make_shared<const CountedString>();
    const Token token = peek();
    if (!begins_string(token)) {
        const Value* value = find_value(token);
        if (value != nullptr && std::holds_alternative<std::shared_ptr<Array>>(*value)) {
            Value array = *value;
            const Value element = read_element(take(), std::move(array));
            if (const auto* text = std::get_if<String>(&element)) return *text;
        }
        if (!failed()) expected("a string");
        return empty;
    }
    take();
    if (token.kind == TokenKind::string) {
        const std::string_view text = text_of(token);
        spend(text.size());
        has_text_beyond_ascii_ |= is_beyond_ascii(text);
        return text.size() > k_max_string ? empty : make_counted<const CountedString>(string_value(text));
    }
    if (!Names::is_reserved(token.name)) {
        return std::get<String>(*find_value(token));
    }
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('(')) return empty;
    CountedString text = string_function(token.word());
    if (!failed()) expect(')');
    spend(text.size());
    if (text.size() > k_max_string) error(token, fmt::format("a string of more than {} bytes", k_max_string));
    return make_counted<const CountedString>(std::move(text));
}

CountedString ValueParser::string_function(Word word) {
    switch (word) {
        case Word::k_concat: {
            CountedString text;
            while (!failed() && !peek().is(')') && text.size() <= k_max_string) {
                text += *string();
                accept(',');
            }
            return text;
        }
        case Word::k_chr: {
            const double code = number();
            const double byte = code > 0 ? std::min(code, 255.0) : 0;  // not a number: 0
            return CountedString(1, static_cast<char>(static_cast<unsigned char>(byte)));
        }
        case Word::k_substr: {
            const String text = string();
            accept(',');
            const Token at = peek();
            const double from = argument(), count = number();
            if (!(from >= 1 && count >= 0 && from - 1 + count <= static_cast<double>(text->size()))) {
                error(at, "expected a part of the string: its first character, from 1, and its length");
                return {};
            }
            return text->substr(static_cast<std::size_t>(from) - 1, static_cast<std::size_t>(count));
        }
        case Word::k_strlwr:
        case Word::k_strupr: {
            CountedString text = *string();
            for (char& c : text) {
                if (word == Word::k_strlwr && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
                if (word == Word::k_strupr && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
            }
            return text;
        }
        case Word::k_str: {
            const double value = argument(), length = argument();
            return CountedString(format_number(value, length, number()));
        }
        case Word::k_vstr: {
            const double terms = argument();
            const Numbers value = promoted(expression(), 5);
            accept(',');
            const String separator = string();
            accept(',');
            const double length = argument(), decimals = number();
            CountedString text;
            for (std::size_t i = 0; i < 5 && static_cast<double>(i) < terms && text.size() < k_max_string;
                 ++i) {
                if (i > 0) text += *separator;
                text += format_number(value.v[i], length, decimals);
            }
            return text;
        }
        default:  // datetime
            number();
            while (!failed() && accept(',')) string();
            return {};
    }
}

bool ValueParser::is_beyond_ascii(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) > 127; });
}

// As std::string::compare().
int ValueParser::compare(std::string_view a, std::string_view b) {
    spend(std::min(a.size(), b.size()) / 64);
    return a.compare(b);
}

double ValueParser::value_of(const Token& at, std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '+')) text.remove_prefix(1);
    double value = 0;
    const bool is_number =
        !text.empty() && read_any_number(text.data(), text.data() + text.size(), value) != text.data();
    if (!is_number || !(value <= 1e300 && value >= -1e300)) {
        error(at, fmt::format("expected a string that is a number, found {}", quoted(text)));
    }
    return value;
}

}  // namespace glint::povray
