// SPDX-License-Identifier: Apache-2.0
#pragma once
// What every reader does with tokens: looks one ahead, says what it expected, and finds its footing again
// after a mistake.
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "formats/tokenizer.h"
#include "glint/vec.h"
#include "scene/ranges.h"

namespace glint {

/// Brackets nest this deep and no deeper.
inline constexpr int k_max_nesting = 256;

/// A key that a block may have.
struct Field {
    std::string_view name;
    bool required = false;
    bool repeats = false;  ///< may be given several times
};

/// A key of other languages, and what to write instead: "`mirror`".
struct SpellingHint {
    std::string_view name, instead;
};

inline constexpr std::size_t k_max_keys = 64;

/// The keys of one block: which its reader knows, and which it has met. At most k_max_keys.
class FieldSet {
  public:
    /// what: as messages call the block, "sphere". Unknown keys are ignored, with a warning.
    FieldSet(std::string_view what, std::span<const Field> fields) : what_(what), fields_(fields) {}
    /// Unknown keys are mistakes; where there is a spelling hint the message has it.
    FieldSet(std::string_view what, std::span<const Field> fields, std::span<const SpellingHint> hints)
        : what_(what), fields_(fields), hints_(hints), is_strict_(true) {}
    std::string_view what() const { return what_; }
    std::span<const Field> fields() const { return fields_; }
    std::span<const SpellingHint> hints() const { return hints_; }
    bool is_strict() const { return is_strict_; }
    bool has(int index) const { return (met_ >> index & 1u) != 0; }
    void add(int index) { met_ |= std::uint64_t{1} << index; }

  private:
    std::string_view what_;
    std::span<const Field> fields_;
    std::span<const SpellingHint> hints_;
    std::uint64_t met_ = 0;
    bool is_strict_ = false;
};

class Parser {
  public:
    Parser(InputText place, Dialect dialect, Diagnostics& diagnostics);

    const Token& token() const { return token_; }
    /// The current token; the next one becomes current.
    Token take();
    /// The token after the current one.
    Token peek() const;
    bool at_end() const { return token_.kind == TokenKind::end; }
    bool at_closing_bracket() const;
    std::string_view text(const Token& token) const { return place_.text.substr(token.offset, token.length); }
    /// A word, or what a string stands for.
    std::string name(const Token& token) const;

    /// Takes the symbol if it is the current token.
    bool accept(char symbol);
    /// As accept, with an error if it is not there.
    bool expect(char symbol);

    /// Messages say so where they meet what only a program could read: `.map(`, a call, an operator.
    void refuse_code() { refuse_code_ = true; }

    /// "expected X, found Y" at the current token.
    void expected(std::string_view what);
    void error(const Token& token, std::string message);
    void warn(const Token& token, std::string message);
    void note(const Token& token, std::string message);
    /// "glint ignores 'foo' of a sphere; did you mean ...?", once for each name and owner. owner: "", or
    /// "sphere".
    void warn_ignored(std::string_view name, const Token& at, std::string_view owner,
                      std::span<const std::string_view> known);
    /// "'abc'", "the end of the text", ...
    std::string describe(const Token& token) const;

    /// Reads a number. False if there is none. One out of range is an error too, but the text goes on.
    bool number(double& value, const Range& range);
    /// Reads as many numbers (1 to 4) as there are values between the brackets, with commas between them.
    /// After a mistake skips to `close`.
    bool numbers(std::span<double> values, const Range& range, char open, char close);
    bool triple(double (&values)[3], const Range& range, char open, char close);
    bool point(Vec3& value, const Range& range, char open, char close);
    /// Reads one of the words, bare or quoted. expected: "`point` or `ambient`". False if there is none.
    bool choice(std::span<const std::string_view> words, std::string_view expected, int& index);

    /// The index of the key in the set, which notes it; -1, with a message, if the reader does not know it.
    int field(FieldSet& set, const Token& key, std::string_view key_name);
    /// Reports, at `block`, the keys that a block must have and has not. False if there are any.
    bool check_required(const FieldSet& set, const Token& block);

    /// Skips a word, a number, a string, or brackets with all that is in them. False after an error.
    bool skip_value();
    /// Skips to the `close` that ends the brackets we are in, and over it; stays before a closing bracket
    /// that does not fit.
    void skip_to_close(char close);
    /// Skips the rest of a value: to a comma or a closing bracket of the brackets we are in.
    void skip_to_separator();
    /// Nothing more is read from this text.
    void stop();

    /// False once the text was stopped, or as many errors were found as anyone reads.
    bool alive() const { return !stopped_; }

  private:
    void advance();
    void report_progress();
    bool looks_like_code() const;
    template <class IsEnd> void skip_until(IsEnd&& is_end);
    void report_unknown(const FieldSet& set, const Token& key, std::string_view key_name);
    void stop_at_nesting(const Token& token);

    InputText place_;
    Diagnostics& diagnostics_;
    Tokenizer tokenizer_;
    Token token_;
    std::uint32_t until_report_ = 0;  // tokens
    bool stopped_ = false;
    bool is_token_reported_ = false;  // the current token is a mistake by itself, and was named
    bool refuse_code_ = false;
};

}  // namespace glint
