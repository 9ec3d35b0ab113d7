// SPDX-License-Identifier: Apache-2.0
#pragma once
// Blocks and settings as in the book's listings: word { key = value ... } and word = value. glint's
// own language adds names before the brace, nested blocks, and include "file".
#include <fmt/format.h>

#include <optional>
#include <vector>

#include "base/text.h"
#include "formats/parser.h"

namespace glint {

/// The features that a format has in addition to blocks and settings.
struct BlockSyntax {
    std::string_view include;  ///< the word before a file name; empty: no includes
    bool names = false;        ///< word NAME { }, word "name" { }
};

/// Reads a text of blocks and settings. After an error it continues at the next key or block, so that one run
/// reports many errors.
class BlockReader {
  public:
    /// words: the known blocks and settings; if empty, the callbacks decide about every word;
    /// what: the same for messages, "`sphere` or `light`".
    BlockReader(Parser& parser, std::span<const std::string_view> words, std::string_view what,
                BlockSyntax syntax = {})
        : p_(parser), words_(words), what_(what), syntax_(syntax) {}

    /// Reads the whole text. on_block(word, name) reads the fields of the block at the parser's token;
    /// on_setting(word, name) reads a value. Both return false if there is none, or if they do not know
    /// the name.
    template <class OnBlock, class OnSetting> void read(OnBlock&& on_block, OnSetting&& on_setting) {
        read(
            on_block, on_setting, [](const Token&) { return false; }, [] {});
    }

    /// on_include(word) reads the rest of an include, and on_close() ends the innermost open block.
    template <class OnBlock, class OnSetting, class OnInclude, class OnClose>
    void read(OnBlock&& on_block, OnSetting&& on_setting, OnInclude&& on_include, OnClose&& on_close) {
        if (p_.at_end()) p_.expected(what_);
        while (!p_.at_end() || pending_) {
            if (!open_.empty() && !pending_ && p_.accept('}')) {
                open_.pop_back();
                on_close();
                continue;
            }
            const auto word = next_word();
            if (!word) continue;
            const auto name = p_.text(*word);
            if (name == syntax_.include && !p_.token().is('=') && !p_.token().is('{')) {
                if (!on_include(*word)) skip_line(*word);
                continue;
            }
            take_label();
            if (p_.token().is('{')) {
                if (!is_known(*word)) {
                    skip_block();
                } else if (!on_block(*word, name)) {
                    p_.expected(fmt::format("`=` after {}", quoted(name)));
                    skip_block();
                }
            } else if (p_.accept('=')) {
                if (!(is_known(*word) ? on_setting(*word, name) : skip_value())) skip_bad_value();
            } else {
                p_.expected(fmt::format("`{{` or `=` after {}", quoted(name)));
                skip_line(*word);
            }
        }
        if (!open_.empty() && p_.alive()) {
            p_.expected(fmt::format("`}}`: the block that begins in line {} has no end", open_.back().line));
        }
    }

    /// The block that starts here contains blocks and settings, up to on_close. False if blocks are
    /// nested too deeply: nothing more is read.
    bool open(const Token& block) {
        if (open_.size() == k_max_nesting) {
            p_.error(block, fmt::format("blocks are nested more than {} deep", k_max_nesting));
            p_.stop();
            return false;
        }
        p_.expect('{');
        open_.push_back(block);
        return true;
    }

    /// The open blocks, from the outermost.
    std::span<const Token> open_blocks() const { return open_; }

    /// The name between the last block's word and its brace.
    const std::optional<Token>& label() const { return label_; }

    /// Skips the block that starts here.
    void skip_block() {
        if (!p_.skip_value()) p_.skip_to_close('}');
    }

    /// Reads the keys and values of the block that starts here; `block` is its word. read_field(index, key)
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
            if (p_.token().is('{') || at_label()) {
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
    bool at_label() const {
        const TokenKind kind = p_.token().kind;
        return syntax_.names && (kind == TokenKind::word || kind == TokenKind::string) && p_.peek().is('{');
    }

    void take_label() {
        label_.reset();
        if (at_label()) label_ = p_.take();
    }

    void skip_line(const Token& word) {
        while (!p_.at_end() && p_.token().line == word.line && !(p_.at_closing_bracket() && !open_.empty()))
            p_.take();
    }

    // The word of a block or a setting; nothing after an error.
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
        if (words_.empty()) return true;
        const auto name = p_.text(word);
        for (const auto known : words_) {
            if (name == known) return true;
        }
        p_.warn_ignored(name, word, "", words_);
        return false;
    }

    // After an error: skips to the end of the block, or to a block that starts before it.
    bool recover() {
        Token last;
        while (!p_.at_end() && !p_.accept('}')) {
            if (last.kind == TokenKind::word && (p_.token().is('{') || at_label())) {
                pending_ = last;
                break;
            }
            last = p_.take();
        }
        return false;
    }

    // Skips a value: everything up to the next key, block, or end of this block.
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
    BlockSyntax syntax_;
    std::vector<Token> open_;
    std::optional<Token> label_;
    std::optional<Token> pending_;  // the word of a block, taken when its `{` was read
};

}  // namespace glint
