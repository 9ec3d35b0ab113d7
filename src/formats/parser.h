// SPDX-License-Identifier: Apache-2.0
#pragma once
// Common to all readers: one token of look-ahead, messages about what was expected, and recovery after a
// mistake.
#include <array>
#include <bitset>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "formats/tokenizer.h"
#include "glint/vec.h"
#include "scene/ranges.h"

namespace glint {

/// The maximum nesting depth of brackets.
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

inline constexpr std::size_t k_max_keys = 128;

/// The keys of one block: those that its reader knows, and those read so far. At most k_max_keys.
class FieldSet {
  public:
    /// what: the name of the block in messages, "sphere". Unknown keys are ignored, with a warning.
    FieldSet(std::string_view what, std::span<const Field> fields) : what_(what), fields_(fields) {}
    /// Unknown keys are errors, with the spelling hint if there is one.
    FieldSet(std::string_view what, std::span<const Field> fields, std::span<const SpellingHint> hints)
        : what_(what), fields_(fields), hints_(hints), is_strict_(true) {}
    std::string_view what() const { return what_; }
    std::span<const Field> fields() const { return fields_; }
    std::span<const SpellingHint> hints() const { return hints_; }
    bool is_strict() const { return is_strict_; }
    bool has(int index) const { return met_.test(static_cast<std::size_t>(index)); }
    void add(int index) { met_.set(static_cast<std::size_t>(index)); }

  private:
    std::string_view what_;
    std::span<const Field> fields_;
    std::span<const SpellingHint> hints_;
    std::bitset<k_max_keys> met_;
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
    /// A word, or the decoded value of a string.
    std::string name(const Token& token) const;

    /// Takes the symbol if it is the current token.
    bool accept(char symbol);
    /// As accept(), with an error if the symbol is missing.
    bool expect(char symbol);

    /// Makes messages mention program code: `.map(`, a call, an operator.
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

    /// Reads a number. False if there is none. A number out of range is an error, but reading continues.
    bool number(double& value, const Range& range);
    /// Reads as many numbers (1 to 4) as there are values between the brackets, with commas between them.
    /// After a mistake, skips to `close`.
    bool numbers(std::span<double> values, const Range& range, char open, char close);
    bool triple(double (&values)[3], const Range& range, char open, char close);
    bool point(Vec3& value, const Range& range, char open, char close);
    /// Reads one of the words, bare or quoted. expected: "`point` or `ambient`". False if there is none.
    bool choice(std::span<const std::string_view> words, std::string_view expected, int& index);

    /// Marks the key as read and returns its index in the set; -1, with a message, if it is unknown.
    int field(FieldSet& set, const Token& key, std::string_view key_name);
    /// Reports, at `block`, required keys that are missing. False if there are any.
    bool check_required(const FieldSet& set, const Token& block);

    /// Skips a word, a number, a string, or brackets with their contents. False after an error.
    bool skip_value();
    /// Skips past the `close` that ends the current brackets. Stops before a closing bracket that does not
    /// match.
    void skip_to_close(char close);
    /// Skips the rest of a value: to a comma or a closing bracket of the current brackets.
    void skip_to_separator();
    /// Stops reading this text.
    void stop();

    /// False after stop(), or when the maximum number of errors has been reached.
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
    bool is_token_reported_ = false;  // an error of the current token itself has been reported
    bool refuse_code_ = false;
};

}  // namespace glint
