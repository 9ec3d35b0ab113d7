// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tokenizer of all formats: one pass, with constant work per byte.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace glint {

/// The differences between the formats' texts.
struct Dialect {
    bool hash_comments = false;   ///< # to the end of the line
    bool slash_comments = false;  ///< // // to the end of the line
    bool block_comments = false;  ///< /* to */
    bool single_quotes = false;   ///< 'strings' as well as "strings"
};

/// malformed: starts like a number and continues like a word ("12abc"). The last three are errors of the text
/// itself.
enum class TokenKind : std::uint8_t {
    end,
    number,
    word,
    string,
    symbol,
    malformed,
    open_string,
    open_comment,
    bad_byte
};

struct Token {
    TokenKind kind = TokenKind::end;
    char symbol = 0;           ///< the character of a symbol
    std::uint32_t line = 1;    ///< from 1
    std::uint32_t column = 1;  ///< in bytes from 1
    std::size_t offset = 0;    ///< of the first byte
    std::size_t length = 0;    ///< in bytes; strings include their quotes
    double number = 0;         ///< of a number; infinite if it is outside the range of double

    bool is(char c) const { return kind == TokenKind::symbol && symbol == c; }
};

/// A number is [+-] digits [. digits] [e [+-] digits], also `4.` and `.5`. A word is letters, digits, _,
/// $ and all bytes above 127, with an optional sign before it (-inf). Every other printable character is
/// a symbol.
class Tokenizer {
  public:
    Tokenizer(std::string_view text, Dialect dialect);

    /// The next token. At the end of the text, and after an invalid byte, it is always `end`.
    Token next();

    /// All further tokens are `end`.
    void stop() { position_ = end_; }

  private:
    bool skip_blanks(Token& token);
    void read_number(Token& token);
    void read_string(Token& token);

    const char* begin_;
    const char* end_;
    const char* position_;
    const char* line_start_;
    std::uint32_t line_ = 1;
    Dialect dialect_;
};

/// The characters between a string token's quotes, with decoded escapes (\n \t \" \\ \/ \b \f \r \' \uXXXX).
/// An unknown escape stands for its character.
std::string string_value(std::string_view token_text);

}  // namespace glint
