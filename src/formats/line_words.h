// SPDX-License-Identifier: Apache-2.0
#pragma once
// Words between blanks, line by line: the texts of .obj, .mtl and .stl.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "formats/number_text.h"

namespace glint {

/// Lines end with LF, CR LF or CR.
class LineWords {
  public:
    enum class Syntax {
        plain,
        wavefront  ///< a word that begins with `#` starts a comment; `\` before the line's end continues it
    };
    LineWords(std::string_view text, Syntax syntax)
        : text_(text), is_wavefront_(syntax == Syntax::wavefront) {
        if (text.starts_with("\xef\xbb\xbf")) at_ = 3;  // the byte order mark of some editors
    }

    /// Goes to the first line, or to the next one. False at the end of the text.
    bool next_line() {
        if (is_begun_) {
            while (!next().empty()) {
            }
            at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());  // a comment
            pass_line_end(line_end_length(at_));
        }
        is_begun_ = true;
        start_ = at_;
        found_ = {};
        return at_ < text_.size();
    }
    /// The next word of the line; empty at its end.
    std::string_view next() {
        skip_blanks();
        start_ = at_;
        if (at_ < text_.size() && text_[at_] == '#' && is_wavefront_) return found_ = {};
        while (at_ < text_.size() && !is_blank(text_[at_]) && line_end_length(at_) == 0 &&
               continuation_length(at_) == 0)
            ++at_;
        return found_ = text_.substr(start_, at_ - start_);
    }
    /// The next word of this line or a later one; empty at the end of the text.
    std::string_view next_of_text() {
        while (next().empty()) {
            if (!next_line()) break;
        }
        return found_;
    }
    /// The rest of the line without blanks around it: names may have blanks inside.
    std::string_view rest() {
        skip_blanks();
        start_ = at_;
        at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
        found_ = text_.substr(start_, at_ - start_);
        for (std::size_t i = 0; i < found_.size() && is_wavefront_; ++i) {
            if (found_[i] == '#' && (i == 0 || is_blank(found_[i - 1]))) found_ = found_.substr(0, i);
        }
        while (!found_.empty() && is_blank(found_.back())) found_.remove_suffix(1);
        return found_;
    }

    /// The same from the last word on, which it contains.
    std::string_view rest_from_word() {
        at_ = start_;
        return rest();
    }

    /// Of the last word or rest, or of the place where none was.
    std::size_t start() const { return start_; }
    std::size_t length() const { return std::max<std::size_t>(found_.size(), 1); }
    std::string_view found() const { return found_; }
    std::size_t offset() const { return at_; }
    /// From 1; as in messages, only LF counts.
    std::uint32_t line() const { return line_; }

  private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    // 0 if no line ends there.
    std::size_t line_end_length(std::size_t at) const {
        if (at >= text_.size() || (text_[at] != '\r' && text_[at] != '\n')) return 0;
        return text_[at] == '\r' && at + 1 < text_.size() && text_[at + 1] == '\n' ? 2 : 1;
    }
    std::size_t continuation_length(std::size_t at) const {
        if (!is_wavefront_ || text_[at] != '\\') return 0;
        const std::size_t end = line_end_length(at + 1);
        return end == 0 ? 0 : 1 + end;
    }
    // Or a blank.
    void pass_line_end(std::size_t length) {
        at_ += length;
        if (length > 0 && text_[at_ - 1] == '\n') ++line_;
    }
    void skip_blanks() {
        while (at_ < text_.size()) {
            const std::size_t length = is_blank(text_[at_]) ? 1 : continuation_length(at_);
            if (length == 0) return;
            pass_line_end(length);
        }
    }

    std::string_view text_, found_;
    bool is_wavefront_, is_begun_ = false;
    std::size_t at_ = 0, start_ = 0;
    std::uint32_t line_ = 1;
};

/// Reads a word that is a number. It may be infinite or NaN.
inline bool read_number_word(std::string_view word, double& value) {
    const char* from = word.data();
    const char* const end = from + word.size();
    if (from != end && *from == '+') ++from;
    if (from == end) return false;
    const char* after = read_short_number(from, end, value, [](char) { return true; });
    if (after == nullptr) after = read_any_number(from, end, value);
    return after == end;
}

/// Whether a text's number needs no more than single precision: it is one, or the shortest text of one.
inline bool is_single_number(double value) {
    const auto single = static_cast<float>(value);
    if (static_cast<double>(single) == value) return true;
    if (!std::isfinite(single)) return false;
    char text[32];
    const char* const end = fmt::format_to(static_cast<char*>(text), "{}", single);
    double back = 0;
    return read_any_number(static_cast<const char*>(text), end, back) == end && back == value;
}

}  // namespace glint
