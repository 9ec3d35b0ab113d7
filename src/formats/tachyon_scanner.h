// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tachyon's words: separated by white space, with `#` comments to the end of the line.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "formats/number_text.h"
#include "formats/tokenizer.h"

namespace glint {

/// One word of look-ahead, which is not copied. Keywords are compared without case.
class TachyonScanner {
  public:
    explicit TachyonScanner(std::string_view text)
        : begin_(text.data()), end_(begin_ + text.size()), at_(begin_), line_start_(begin_) {
        if (text.starts_with("\xef\xbb\xbf")) at_ += 3;  // a byte order mark
        skip_blanks();
    }

    bool at_end() const { return at_ == end_; }
    std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    /// `count` items of at least three numbers, or as many as may follow at most.
    std::size_t at_most(double count) const {
        const std::size_t possible = static_cast<std::size_t>(end_ - at_) / 6 + 1;
        return count < static_cast<double>(possible) ? static_cast<std::size_t>(count) : possible;
    }

    /// The place of a word; cheaper than its token.
    struct Mark {
        const char *at, *line_start;
        std::uint32_t line;
    };
    Mark mark() const { return {at_, line_start_, line_}; }

    /// The word at a mark, as a token with its place; kind end at the end of the text.
    Token token(const Mark& mark) const {
        Token token;
        token.kind = mark.at == end_ ? TokenKind::end : TokenKind::word;
        token.line = mark.line;
        token.column = static_cast<std::uint32_t>(mark.at - mark.line_start) + 1;
        token.offset = static_cast<std::size_t>(mark.at - begin_);
        token.length = static_cast<std::size_t>(word_end(mark.at) - mark.at);
        return token;
    }
    /// The current word's.
    Token token() const { return token(mark()); }
    std::string_view word() const { return {at_, static_cast<std::size_t>(word_end(at_) - at_)}; }

    void take() {
        at_ = word_end(at_);
        skip_blanks();
    }
    /// Takes the current word if it is the keyword. upper: in capital letters.
    bool accept(std::string_view upper) {
        const char* at = at_;
        for (const char c : upper) {
            if (at == end_ || upper_case(*at) != c) return false;
            ++at;
        }
        if (at != end_ && !is_blank(*at)) return false;
        at_ = at;
        skip_blanks();
        return true;
    }
    /// Takes the current word if it is a number; infinite if it is outside the range of double.
    bool accept_number(double& value) {
        const char* from = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
        const char* digit = from != end_ && *from == '-' ? from + 1 : from;
        if (digit != end_ && *digit == '.') ++digit;
        if (digit == end_ || !is_decimal_digit(*digit)) return false;
        const char* at = read_short_number(from, end_, value, [](char c) { return !is_blank(c); });
        if (at == nullptr) {
            at = read_any_number(from, end_, value);
            if (at == from || (at != end_ && !is_blank(*at))) return false;
        }
        at_ = at;
        skip_blanks();
        return true;
    }

    /// Words that were read, so that the same bytes need not be read again.
    struct Passage {
        std::string_view text;
        std::uint32_t lines = 0;    ///< line ends in it
        std::size_t last_line = 0;  ///< bytes after its last line end
    };
    /// From `start`, a place that the scanner has passed, to the current word, without the blanks before
    /// that.
    Passage passage(const Token& start) const {
        const char* const first = begin_ + start.offset;
        const char* last = at_;
        while (last != first && is_blank(last[-1])) --last;
        Passage passage{{first, static_cast<std::size_t>(last - first)}};
        for (const char* c = first; c != last; ++c) {
            if (*c != '\n') continue;
            ++passage.lines;
            passage.last_line = static_cast<std::size_t>(last - c) - 1;
        }
        return passage;
    }
    /// Takes the words of the passage if they follow, with the same blanks.
    bool accept(const Passage& passage) {
        const std::size_t size = passage.text.size();
        if (size == 0 || static_cast<std::size_t>(end_ - at_) < size) return false;
        if (std::string_view(at_, size) != passage.text) return false;
        const char* const at = at_ + size;
        if (at != end_ && !is_blank(*at)) return false;
        at_ = at;
        if (passage.lines != 0) {
            line_ += passage.lines;
            line_start_ = at - passage.last_line;
        }
        skip_blanks();
        return true;
    }

    /// The rest of the text is not read.
    void stop() { at_ = end_; }

    static char upper_case(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  private:
    const char* word_end(const char* at) const {
        while (at != end_ && !is_blank(*at)) ++at;
        return at;
    }
    void skip_blanks() {
        for (; at_ != end_; ++at_) {
            const char c = *at_;
            if (c == '\n') {
                ++line_;
                line_start_ = at_ + 1;
            } else if (c == '#') {
                while (at_ + 1 != end_ && at_[1] != '\n') ++at_;
            } else if (!is_blank(c)) {
                return;
            }
        }
    }

    const char* begin_;
    const char* end_;
    const char* at_;
    const char* line_start_;
    std::uint32_t line_ = 1;
};

}  // namespace glint
