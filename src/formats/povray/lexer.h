// SPDX-License-Identifier: Apache-2.0
#pragma once
// A text of POV-Ray's language as tokens. Each text is lexed once: loops and macros read its tokens again.
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/memory_budget.h"
#include "formats/povray/words.h"

namespace glint::povray {

/// end: of a text, of a macro's body, or of what may be read now. directive: `#` and its word. list: what
/// number_list.h reads, in the block of a mesh.
enum class TokenKind : std::uint8_t { end, number, word, directive, string, symbol, list };

struct Token {
    double number = 0;         // of a number
    std::uint32_t name = 0;    // of a word or directive: a Word, or an identifier of Names; of a string or
                               // list: its length, with quotes
    std::uint32_t offset = 0;  // of the first byte
    std::uint16_t text = 0;    // SourcePlace::file
    TokenKind kind = TokenKind::end;
    char symbol = 0;  // of a symbol; `<=`, `>=` and `!=` are 'l', 'g' and 'n'

    bool is(char c) const { return kind == TokenKind::symbol && symbol == c; }
    Word word() const { return kind == TokenKind::word ? static_cast<Word>(name) : Word::k_none; }
    Word directive() const { return kind == TokenKind::directive ? static_cast<Word>(name) : Word::k_none; }
};

/// The words and identifiers of a load, by number: first the Words, then the identifiers.
class Names {
  public:
    Names();
    std::uint32_t number_of(std::string_view name);
    std::string_view name(std::uint32_t number) const { return names_[number]; }
    std::size_t size() const { return names_.size(); }
    static bool is_reserved(std::uint32_t number) {
        return number < static_cast<std::uint32_t>(Word::k_count);
    }

  private:
    std::deque<CountedString, Counted<CountedString>> storage_;
    CountedVector<std::string_view> names_;
    CountedMap<std::string_view, std::uint32_t> numbers_;  // ordered: no choice of names makes it slow
    std::array<std::uint32_t, 1024> recent_{};             // by a hash of the name
};

/// A mistake of the text itself; offset and length are its place.
struct LexError {
    std::string message;  // empty: none
    std::uint32_t offset = 0, length = 0;
};

/// The tokens of a text; the last one has the kind `end`.
struct LexedText {
    CountedVector<Token> tokens;
    std::uint64_t list_bytes = 0;  ///< of all lists
    LexError error;
};

/// number: SourcePlace::file of the text.
LexedText lex(std::string_view text, std::uint16_t number, Names& names);

}  // namespace glint::povray
