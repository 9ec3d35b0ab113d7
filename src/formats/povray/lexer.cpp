// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/text.h"
#include "formats/number_text.h"
#include "formats/povray/number_list.h"

namespace glint::povray {
namespace {

constexpr std::size_t k_first_tokens = 4096;
constexpr double k_spare_room = 1.02;  // of the estimate

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}
bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class Lexer {
  public:
    Lexer(std::string_view text, std::uint16_t number, Names& names)
        : begin_(text.data()), end_(text.data() + text.size()), at_(begin_), number_(number), names_(names) {
        if (text.starts_with("\xef\xbb\xbf")) at_ += 3;  // a byte order mark
        if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
            fail(begin_, 1, "expected UTF-8, found UTF-16");
        }
        out_.tokens.reserve(std::min(text.size(), k_first_tokens));
    }

    LexedText run() {
        if (static_cast<std::size_t>(end_ - begin_) > 0xfffffff0u) {
            fail(begin_, 1, "texts of 4 GiB and more are not read");
        }
        const MemoryBudget* memory = MemoryBudget::current();
        // Beyond the budget the rest is not read; the reader reports it.
        while (out_.error.message.empty() && skip_blanks() && at_ != end_ &&
               (memory == nullptr || !memory->is_exceeded())) {
            read_token();
        }
        if (!out_.error.message.empty()) at_ = begin_ + out_.error.offset;
        add(TokenKind::end, at_);
        return std::move(out_);
    }

  private:
    void fail(const char* from, std::size_t length, std::string message) {
        out_.error = {std::move(message), static_cast<std::uint32_t>(from - begin_),
                      static_cast<std::uint32_t>(length)};
    }

    // Room for all tokens, if the rest of the text has as many as what has been read: to copy them as the
    // list grows takes longer than to read them.
    void make_room() {
        const auto read = static_cast<double>(at_ - begin_), size = static_cast<double>(out_.tokens.size());
        const double more = size / std::max(read, 1.0) * static_cast<double>(end_ - at_) * k_spare_room;
        const auto room = out_.tokens.size() + static_cast<std::size_t>(more) + 16;
        const MemoryBudget* memory = MemoryBudget::current();
        if (memory == nullptr || memory->has_room(MemoryBudget::list_bytes(room, sizeof(Token))))
            out_.tokens.reserve(room);
    }

    Token& add(TokenKind kind, const char* from) {
        if (out_.tokens.size() == out_.tokens.capacity()) make_room();
        Token& token = out_.tokens.emplace_back();
        token.kind = kind;
        token.offset = static_cast<std::uint32_t>(from - begin_);
        token.text = number_;
        return token;
    }

    char after(std::ptrdiff_t n) const { return end_ - at_ > n ? at_[n] : '\0'; }

    // False after a comment that does not end.
    bool skip_blanks() {
        while (at_ != end_) {
            if (is_blank(*at_)) {
                ++at_;
            } else if (*at_ == '/' && after(1) == '/') {
                // A line may end with CR alone.
                while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
            } else if (*at_ == '/' && after(1) == '*') {
                if (!skip_comment()) return false;
            } else {
                break;
            }
        }
        return true;
    }

    // Comments nest.
    bool skip_comment() {
        const char* start = at_;
        std::size_t depth = 0;
        do {
            if (*at_ == '/' && after(1) == '*') {
                ++depth;
                at_ += 2;
            } else if (*at_ == '*' && after(1) == '/') {
                --depth;
                at_ += 2;
            } else {
                ++at_;
            }
        } while (depth != 0 && at_ != end_);
        if (depth == 0) return true;
        fail(start, 2, "this comment does not end: comments nest in POV-Ray's language");
        return false;
    }

    void read_token() {
        const char c = *at_;
        if (is_decimal_digit(c) || (c == '.' && is_decimal_digit(after(1)))) return read_number();
        if (is_letter(c)) {
            const char* from = at_;
            add(TokenKind::word, from).name = read_name();
        } else if (c == '"') {
            read_string();
        } else if (c == '#') {
            read_directive();
        } else if (c < 0x20 || c == 0x7f) {
            fail(at_, 1, fmt::format("expected text, found the byte 0x{:02x}", static_cast<unsigned>(c)));
        } else {
            const char* from = at_++;
            Token& token = add(TokenKind::symbol, from);
            token.symbol = c;
            if (at_ != end_ && *at_ == '=' && (c == '<' || c == '>' || c == '!')) {
                ++at_;
                token.symbol = c == '<' ? 'l' : c == '>' ? 'g' : 'n';
            }
            if (c == '{') read_list();
        }
    }

    // The lists of meshes, which can be most of a text: as tokens they would take many times their length.
    void read_list() {
        if (out_.tokens.size() < 2) return;
        switch (out_.tokens[out_.tokens.size() - 2].word()) {
            case Word::k_vertex_vectors:
            case Word::k_normal_vectors:
            case Word::k_uv_vectors:
            case Word::k_face_indices:
            case Word::k_normal_indices:
            case Word::k_uv_indices:
                break;
            default:
                return;
        }
        const char* const end = end_of_number_list(at_, end_);
        if (end == nullptr || end == at_) return;
        add(TokenKind::list, at_).name = static_cast<std::uint32_t>(end - at_);
        out_.list_bytes += static_cast<std::uint64_t>(end - at_);
        at_ = end;
    }

    std::uint32_t read_name() {
        const char* from = at_;
        while (at_ != end_ && (is_letter(*at_) || is_decimal_digit(*at_))) ++at_;
        return names_.number_of({from, static_cast<std::size_t>(at_ - from)});
    }

    void read_number() {
        const char* from = at_;
        double value = 0;
        const char* const end = read_any_number(from, end_, value);
        if (end == from) return fail(from, 1, "expected a number");
        if (!(value <= 1e300)) value = 1e300;
        add(TokenKind::number, from).number = value;
        at_ = end;
    }

    void read_string() {
        const char* from = at_++;
        // A string may go on over the end of its line.
        while (at_ != end_ && *at_ != '"') at_ += *at_ == '\\' && at_ + 1 != end_ ? 2 : 1;
        if (at_ == end_) return fail(from, 1, "this string does not end");
        ++at_;
        add(TokenKind::string, from).name = static_cast<std::uint32_t>(at_ - from);
    }

    // `#` and its word, with blanks or comments between them.
    void read_directive() {
        const char* from = at_++;
        if (!skip_blanks()) return;
        const char* name = at_;
        const std::uint32_t number =
            at_ != end_ && is_letter(*at_) ? read_name() : static_cast<std::uint32_t>(Word::k_count);
        if (number == static_cast<std::uint32_t>(Word::k_count)) return;  // `#` alone means nothing
        if (number > static_cast<std::uint32_t>(Word::k_write)) {
            const std::string_view found(name, static_cast<std::size_t>(at_ - name));
            return fail(from, 1, fmt::format("expected a directive after '#', found {}", quoted(found)));
        }
        add(TokenKind::directive, from).name = number;
    }

    const char* begin_;
    const char* end_;
    const char* at_;
    std::uint16_t number_;
    Names& names_;
    LexedText out_;
};

}  // namespace

Names::Names() {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(Word::k_count); ++i) {
        names_.push_back(to_string(static_cast<Word>(i)));
        numbers_.emplace(names_.back(), i);
    }
}

std::uint32_t Names::number_of(std::string_view name) {
    std::size_t hash = name.size();
    for (std::size_t i = 0; i < name.size() && i < 16; ++i) {
        hash = hash * 31 + static_cast<unsigned char>(name[i]);
    }
    std::uint32_t& recent = recent_[hash % recent_.size()];
    if (names_[recent] == name) return recent;
    auto known = numbers_.find(name);
    if (known == numbers_.end()) {
        const auto number = static_cast<std::uint32_t>(names_.size());
        names_.push_back(storage_.emplace_back(name));
        known = numbers_.emplace(names_.back(), number).first;
    }
    return recent = known->second;
}

LexedText lex(std::string_view text, std::uint16_t number, Names& names) {
    return Lexer(text, number, names).run();
}

}  // namespace glint::povray
