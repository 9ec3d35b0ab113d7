#pragma once
// Blocks and settings as the book's listings write them: word { key = value ... } and word = value.
#include <fmt/format.h>

#include <optional>

#include "base/text.h"
#include "formats/parser.h"

namespace glint {

/// Reads a text of blocks and settings. After a mistake it goes on at the next key or block, so that one run
/// finds many.
class BlockReader {
  public:
    /// words: the blocks and settings that the format knows; what: the same for messages, "`sphere` or
    /// `light`".
    BlockReader(Parser& parser, std::span<const std::string_view> words, std::string_view what)
        : p_(parser), words_(words), what_(what) {}

    /// The whole text. on_block(word, name) reads the fields of the block that begins at the parser's token;
    /// on_setting(word, name) reads a value. Both return false before what is none, or if they do not know
    /// the name.
    template <class OnBlock, class OnSetting> void read(OnBlock&& on_block, OnSetting&& on_setting) {
        if (p_.at_end()) p_.expected(what_);
        while (!p_.at_end() || pending_) {
            const auto word = next_word();
            if (!word) continue;
            const auto name = p_.text(*word);
            if (p_.token().is('{')) {
                if (!is_known(*word)) {
                    if (!p_.skip_value()) p_.skip_to_close('}');
                } else if (!on_block(*word, name)) {
                    p_.expected(fmt::format("`=` after {}", quoted(name)));
                    if (!p_.skip_value()) p_.skip_to_close('}');
                }
            } else if (p_.accept('=')) {
                if (!(is_known(*word) ? on_setting(*word, name) : skip_value())) skip_bad_value();
            } else {
                p_.expected(fmt::format("`{{` or `=` after {}", quoted(name)));
                while (!p_.at_end() && p_.token().line == word->line) p_.take();
            }
        }
    }

    /// The keys and values of the block that begins here, `block` being its word. read_field(index, key)
    /// reads the value of field number `index` of the set. False if the block has no end.
    template <class ReadField> bool fields(FieldSet& set, const Token& block, ReadField&& read_field) {
        p_.expect('{');
        while (!p_.accept('}')) {
            if (p_.accept(',') || p_.accept(';')) continue;
            if (p_.at_end()) {
                p_.expected(fmt::format("`}}`: the block that begins in line {} has no end", block.line));
                return false;
            }
            if (p_.token().kind != TokenKind::word) {
                p_.expected("a key or `}`");
                return recover();
            }
            const Token key = p_.take();
            if (p_.token().is('{')) {
                p_.error(key,
                         fmt::format("expected `}}` before {}: the block that begins in line {} has no end",
                                     p_.describe(key), block.line));
                pending_ = key;
                return false;
            }
            if (!p_.expect('=')) return recover();
            const int index = p_.field(set, key, p_.text(key));
            if (!(index < 0 ? skip_value() : read_field(index, key))) skip_bad_value();
        }
        return true;
    }

  private:
    // The word of a block or a setting, or nothing after what is none.
    std::optional<Token> next_word() {
        if (pending_) {
            const Token word = *pending_;
            pending_.reset();
            return word;
        }
        if (p_.accept(',') || p_.accept(';')) return std::nullopt;
        if (p_.token().kind == TokenKind::word) return p_.take();
        p_.expected(what_);
        if (p_.at_closing_bracket() || !p_.skip_value()) p_.take();
        return std::nullopt;
    }

    bool is_known(const Token& word) {
        const auto name = p_.text(word);
        for (const auto known : words_) {
            if (name == known) return true;
        }
        p_.warn_ignored(name, word, "", words_);
        return false;
    }

    // After a mistake: to the end of the block, or to a block that begins before it.
    bool recover() {
        Token last;
        while (!p_.at_end() && !p_.accept('}')) {
            if (p_.token().is('{') && last.kind == TokenKind::word) {
                pending_ = last;
                break;
            }
            last = p_.take();
        }
        return false;
    }

    // What stands where a value should: all before the next key, block, or end of this block.
    void skip_bad_value() {
        while (!p_.at_end() && !p_.at_closing_bracket() && !p_.peek().is('=') && !p_.peek().is('{')) {
            const bool in_brackets = p_.token().is('(');
            p_.take();
            if (in_brackets) p_.skip_to_close(')');
        }
    }

    bool skip_value() {
        if (!p_.skip_value()) return false;
        if (p_.token().kind == TokenKind::word && p_.text(p_.token()) == "x" && !p_.peek().is('=')) {
            p_.take();  // 1 x 1
            return p_.skip_value();
        }
        return true;
    }

    Parser& p_;
    std::span<const std::string_view> words_;
    std::string_view what_;
    std::optional<Token> pending_;  // the word of a block, taken when its `{` was met
};

}  // namespace glint
