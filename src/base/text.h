// SPDX-License-Identifier: Apache-2.0
#pragma once
// Words from the user's text, for messages.
#include <span>
#include <string>
#include <string_view>

namespace glint {

/// 'text' for a message: at most about 40 bytes, without control characters and invalid UTF-8.
std::string quoted(std::string_view text);

/// The text in one line, without what would control a terminal: control characters (also U+0080 to U+009F),
/// bytes that are not UTF-8 and the characters that change the direction of text are written as \x1b. The
/// result is unchanged by a second call.
std::string printable(std::string_view text);

/// The same for a text of several lines: newlines and tabs remain.
std::string printable_lines(std::string_view text);

/// Whether printable() keeps the character that `text` begins with, and its length in bytes, at least 1.
struct Character {
    bool is_printable = true;
    std::size_t length = 1;
};
Character first_character(std::string_view text);

/// The candidate that `word` is most likely a misspelling of, or an empty view: at most a third of the
/// letters differ (a swap of neighbours counts as one, and so does f for ph); else the only candidate that
/// begins with `word`, of at least three letters. Looks at the first 1000 candidates.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean `radius`?", or an empty string if no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// "`a`, `b` or `c`".
std::string one_of(std::span<const std::string_view> words);

/// "a point", "an ambient": by the first letter.
std::string with_article(std::string_view word);

/// The value of a hexadecimal digit; -1 of other characters.
int hex_digit(char c);

/// Whether a file's name does not depend on a folder: "/a"; on Windows "C:/a", too.
bool is_absolute_path(std::string_view name);

/// Length in bytes of the well-formed UTF-8 character that `text` begins with; 0 if it begins with none.
std::size_t utf8_length(std::string_view text);

}  // namespace glint
