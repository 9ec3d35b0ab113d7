// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text to tokens, for every format. One pass, constant work a byte, places known at no cost.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace glint {

/// What differs between the formats' texts.
struct Dialect {
    bool hash_comments = false;   ///< # to the end of the line
    bool slash_comments = false;  ///< // to the end of the line
    bool block_comments = false;  ///< /* to */
    bool single_quotes = false;   ///< 'strings' beside "strings"
};

/// malformed: begins like a number and goes on like a word ("12abc"). The last three are mistakes of the text
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
    std::size_t offset = 0;    ///< of its first byte
    std::size_t length = 0;    ///< in bytes; strings with their quotes
    double number = 0;         ///< of a number; infinite if it is out of a double's range

    bool is(char c) const { return kind == TokenKind::symbol && symbol == c; }
};

/// A number is [+-] digits [. digits] [e [+-] digits], `4.` and `.5` included. A word is letters, digits, _,
/// $ and all bytes above 127, with a sign before it if it has one (-inf). Every other printable character is
/// a symbol.
class Tokenizer {
  public:
    Tokenizer(std::string_view text, Dialect dialect);

    /// The next token; at the end of the text, and after a bad byte, `end` for ever.
    Token next();

    /// All tokens from here on are `end`.
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

/// The characters between a string token's quotes, escapes decoded (\n \t \" \\ \/ \b \f \r \' \uXXXX). An
/// escape that means nothing stands for its character.
std::string string_value(std::string_view token_text);

}  // namespace glint
