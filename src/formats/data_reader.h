// SPDX-License-Identifier: Apache-2.0
#pragma once
// Objects and lists as in JSON and JavaScript: also with unquoted keys, single quotes, comments and trailing
// commas.
#include <fmt/format.h>

#include "formats/parser.h"

namespace glint {

/// The dialect of JavaScript's data.
inline constexpr Dialect k_javascript{.slash_comments = true, .block_comments = true, .single_quotes = true};

/// Reads the value that starts at the parser's token. After an error it continues at the next key or element,
/// so that one run reports many. Functions return false only if there is no such value, or if it has no end.
class DataReader {
  public:
    explicit DataReader(Parser& parser) : p_(parser) { p_.refuse_code(); }

    /// { key: value, ... }. read_field(index, key) reads the value of field number `index` of the set.
    template <class ReadField> bool object(FieldSet& set, ReadField&& read_field) {
        const Token block = p_.token();
        if (!p_.accept('{')) {
            p_.expected(fmt::format("a {} `{{ ... }}`", set.what()));
            return false;
        }
        while (!p_.accept('}')) {
            if (p_.at_end()) {
                p_.expected(
                    fmt::format("`}}`: the {} that begins in line {} has no end", set.what(), block.line));
                return false;
            }
            if (!is_key()) {
                p_.expected("a key or `}`");
                p_.skip_to_close('}');
                return true;
            }
            const Token key = p_.take();
            if (p_.expect(':')) {
                const int index = p_.field(set, key, p_.name(key));
                if (!(index < 0 ? p_.skip_value() : read_field(index, key))) p_.skip_to_separator();
            } else {
                p_.skip_to_separator();
            }
            end_of_element('}');
        }
        return true;
    }

    /// [ element, ... ]. read_element() reads one.
    template <class ReadElement> bool list(std::string_view what, ReadElement&& read_element) {
        const Token block = p_.token();
        if (!p_.accept('[')) {
            p_.expected(fmt::format("a list of {} `[ ... ]`", what));
            return false;
        }
        while (!p_.accept(']')) {
            if (p_.at_end()) {
                p_.expected(
                    fmt::format("`]`: the list of {} that begins in line {} has no end", what, block.line));
                return false;
            }
            if (!read_element()) p_.skip_to_separator();
            if (!end_of_element(']')) return true;
        }
        return true;
    }

  private:
    bool is_key() const { return p_.token().kind == TokenKind::word || p_.token().kind == TokenKind::string; }

    // After a value: a comma, or the closing bracket, which stays. False before a bracket that closes
    // something else.
    bool end_of_element(char close) {
        if (p_.accept(',') || p_.token().is(close) || p_.at_end()) return true;
        p_.expected(fmt::format("`,` or `{}`", close));
        // A missing comma: the next token starts the next element.
        if (close == '}' ? is_key() && p_.peek().is(':') : p_.token().is('{')) return true;
        p_.skip_to_separator();
        return p_.accept(',') || p_.token().is(close) || p_.at_end();
    }

    Parser& p_;
};

}  // namespace glint
