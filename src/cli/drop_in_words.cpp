// SPDX-License-Identifier: Apache-2.0
#include "cli/drop_in_words.h"

#include <algorithm>

#include "cli/foreign_table.h"

namespace glint::cli {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

// The next character outside of quotes for which `stops`, or the end. A quote without a second one is a
// letter.
template <class Stops> std::size_t find_unquoted(std::string_view text, std::size_t from, Stops stops) {
    while (from < text.size() && !stops(text[from])) {
        const bool opens = text[from] == '"' || text[from] == '\'';
        const std::size_t close = opens ? text.find(text[from], from + 1) : std::string_view::npos;
        from = (close == std::string_view::npos ? from : close) + 1;
    }
    return std::min(from, text.size());
}

bool begins_option(std::string_view text) {
    if (text.empty() || is_sign(text[0])) return !text.empty();
    const std::size_t equals = text.find('=');
    return equals != std::string_view::npos && find_povray_key(text.substr(0, equals)) != nullptr;
}

}  // namespace

std::string trimmed_value(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    const bool is_quoted =
        text.size() > 1 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
    return std::string(is_quoted ? text.substr(1, text.size() - 2) : text);
}

std::string_view without_comment(std::string_view line) {
    return line.substr(0, find_unquoted(line, 0, [](char c) { return c == ';'; }));
}

std::vector<std::string> split_options(std::string_view text, bool keys_end_values) {
    std::vector<std::string> options;
    for (std::size_t at = 0; at < text.size();) {
        if (is_blank(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = find_unquoted(text, at, is_blank);
        // A switch ends at a blank; the value of a key may have some.
        while (!is_sign(text[at]) && end < text.size() &&
               !(keys_end_values && begins_option(text.substr(end + 1))))
            end = find_unquoted(text, end + 1, is_blank);
        options.emplace_back(text.substr(at, end - at));
        at = end;
    }
    return options;
}

}  // namespace glint::cli
