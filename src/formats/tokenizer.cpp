// SPDX-License-Identifier: Apache-2.0
#include "formats/tokenizer.h"

#include <array>
#include <cstring>

#include "formats/number_text.h"

namespace glint {
namespace {

enum Class : std::uint8_t { k_bad, k_blank, k_digit, k_letter, k_symbol };

constexpr std::array<Class, 256> k_classes = [] {
    std::array<Class, 256> classes{};
    for (int c = 0; c < 256; ++c) {
        const bool letter =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' || c >= 0x80;
        const bool blank = c == ' ' || (c >= '\t' && c <= '\r');
        classes[c] = c >= '0' && c <= '9'    ? k_digit
                     : letter                ? k_letter
                     : blank                 ? k_blank
                     : c < 0x20 || c == 0x7f ? k_bad
                                             : k_symbol;
    }
    return classes;
}();

Class class_of(char c) { return k_classes[static_cast<unsigned char>(c)]; }
bool is_word(char c) { return class_of(c) == k_letter || class_of(c) == k_digit; }

const char* find(const char* from, const char* end, char c) {
    const void* at = std::memchr(from, c, static_cast<std::size_t>(end - from));
    return at ? static_cast<const char*>(at) : end;
}

}  // namespace

Tokenizer::Tokenizer(std::string_view text, Dialect dialect)
    : begin_(text.data()),
      end_(text.data() + text.size()),
      position_(begin_),
      line_start_(begin_),
      dialect_(dialect) {
    if (text.starts_with("\xef\xbb\xbf")) position_ += 3;  // a byte order mark
}

// False if a comment does not end: the token is then that comment.
bool Tokenizer::skip_blanks(Token& token) {
    while (position_ != end_) {
        const char c = *position_;
        const char second = position_ + 1 != end_ ? position_[1] : '\0';
        if (c == '\n') {
            ++line_;
            line_start_ = ++position_;
        } else if (class_of(c) == k_blank) {
            ++position_;
        } else if ((c == '#' && dialect_.hash_comments) ||
                   (c == '/' && second == '/' && dialect_.slash_comments)) {
            position_ = find(position_, end_, '\n');
        } else if (c == '/' && second == '*' && dialect_.block_comments) {
            const char* start = position_;
            const std::uint32_t line = line_;
            const char* line_start = line_start_;
            position_ += 2;
            while (position_ != end_ &&
                   !(*position_ == '*' && position_ + 1 != end_ && position_[1] == '/')) {
                if (*position_++ == '\n') {
                    ++line_;
                    line_start_ = position_;
                }
            }
            if (position_ == end_) {
                token.kind = TokenKind::open_comment;
                token.offset = static_cast<std::size_t>(start - begin_);
                token.line = line;
                token.column = static_cast<std::uint32_t>(start - line_start) + 1;
                token.length = 2;
                return false;
            }
            position_ += 2;
        } else {
            break;
        }
    }
    return true;
}

Token Tokenizer::next() {
    Token token;
    if (!skip_blanks(token)) return token;
    const char* start = position_;
    token.offset = static_cast<std::size_t>(start - begin_);
    token.line = line_;
    token.column = static_cast<std::uint32_t>(start - line_start_) + 1;
    if (start == end_) return token;
    const char c = *start;
    const auto after = [&](std::ptrdiff_t n) { return end_ - start > n ? start[n] : '\0'; };
    const bool is_signed = c == '-' || c == '+';
    const char first = is_signed ? after(1) : c;
    const char second = is_signed ? after(2) : after(1);
    if (is_decimal_digit(first) || (first == '.' && is_decimal_digit(second))) {
        read_number(token);
    } else if (first != '\0' && class_of(first) == k_letter) {
        token.kind = TokenKind::word;
        position_ += is_signed ? 2 : 1;
        while (position_ != end_ && is_word(*position_)) ++position_;
    } else if (c == '"' || (c == '\'' && dialect_.single_quotes)) {
        read_string(token);
    } else if (class_of(c) == k_bad) {
        token.kind = TokenKind::bad_byte;
        token.length = 1;
        stop();
        return token;
    } else {
        token.kind = TokenKind::symbol;
        token.symbol = c;
        ++position_;
    }
    token.length = static_cast<std::size_t>(position_ - start);
    return token;
}

void Tokenizer::read_number(Token& token) {
    token.kind = TokenKind::number;
    const char* from = *position_ == '+' ? position_ + 1 : position_;
    const auto continues = [](char c) { return is_word(c) || c == '.'; };
    if (const char* end = read_short_number(from, end_, token.number, continues)) {
        position_ = end;
        return;
    }
    position_ = read_any_number(from, end_, token.number);
    if (position_ == end_ || !(is_word(*position_) || *position_ == '.')) return;
    token.kind = TokenKind::malformed;
    while (position_ != end_ && (is_word(*position_) || *position_ == '.')) ++position_;
}

// Reads up to the closing quote or, without one, to the end of the line.
void Tokenizer::read_string(Token& token) {
    const char quote = *position_++;
    token.kind = TokenKind::open_string;
    while (position_ != end_ && *position_ != '\n' && *position_ != '\r') {
        const char c = *position_++;
        if (c == quote) {
            token.kind = TokenKind::string;
            return;
        }
        if (c == '\\' && position_ != end_ && *position_ != '\n' && *position_ != '\r') ++position_;
    }
}

namespace {

void append_utf8(std::string& out, std::uint32_t code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | code >> 6);
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        out += static_cast<char>(0xe0 | code >> 12);
        out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xf0 | code >> 18);
        out += static_cast<char>(0x80 | (code >> 12 & 0x3f));
        out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

// Reads four hexadecimal digits at text[at]; false if they are not there.
bool hex4(std::string_view text, std::size_t at, std::uint32_t& code) {
    if (text.size() < at + 4) return false;
    code = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
        const char c = text[i];
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        if (digit < 0) return false;
        code = code * 16 + static_cast<std::uint32_t>(digit);
    }
    return true;
}

}  // namespace

std::string string_value(std::string_view token_text) {
    std::string out;
    if (token_text.empty()) return out;
    const char quote = token_text.front();
    token_text.remove_prefix(1);
    if (!token_text.empty() && token_text.back() == quote) token_text.remove_suffix(1);
    for (std::size_t i = 0; i < token_text.size(); ++i) {
        if (token_text[i] != '\\' || i + 1 == token_text.size()) {
            out += token_text[i];
            continue;
        }
        const char c = token_text[++i];
        std::uint32_t code = 0;
        switch (c) {
            case 'n':
                out += '\n';
                break;
            case 't':
                out += '\t';
                break;
            case 'r':
                out += '\r';
                break;
            case 'b':
                out += '\b';
                break;
            case 'f':
                out += '\f';
                break;
            case 'u':
                if (!hex4(token_text, i + 1, code)) {
                    out += c;
                    break;
                }
                i += 4;
                if (std::uint32_t low = 0; code >= 0xd800 && code < 0xdc00 && i + 2 < token_text.size() &&
                                           token_text[i + 1] == '\\' && token_text[i + 2] == 'u' &&
                                           hex4(token_text, i + 3, low) && low >= 0xdc00 && low < 0xe000) {
                    code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
                    i += 6;
                }
                // Half of a surrogate pair is not a character.
                append_utf8(out, code >= 0xd800 && code < 0xe000 ? 0xfffd : code);
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace glint
