// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tokens of a scene in the order in which they count: directives are carried out, macros and includes are
// replaced by their tokens. Each class of the reader adds a part of the language:
//   TokenStream      tokens, names, messages, limits       token_stream.cpp, bindings.cpp, messages.cpp
//   ValueParser      numbers, strings, arrays              value_parser.h
//   TextureParser    textures, materials, transforms       texture_parser.h
//   ObjectParser     shapes, groups, lights, cameras       object_parser.h
//   DirectiveParser  #declare, #if, #macro, #include ...   directive_parser.h
//   Reader           the statements of a scene             reader.h
// Each derives from the one before it and knows no later one. What is needed of these are three virtual
// functions: read_directive() and call_macro() of TokenStream, other_value() of ValueParser. The Reader has a
// SceneBuilder (scene_builder.h), which places the objects in the Scene; it reads no tokens.
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/load_state.h"
#include "formats/povray/frames.h"
#include "formats/povray/lexer.h"
#include "formats/povray/limits.h"
#include "formats/povray/value.h"

namespace glint::povray {

class TokenStream {
  public:
    TokenStream(LoadState& reading, const ReadText& text) : reading_(reading), text_(text) {}
    virtual ~TokenStream() = default;
    TokenStream(const TokenStream&) = delete;
    TokenStream& operator=(const TokenStream&) = delete;

    // Messages and places.

    /// After an error no token follows.
    void error(const Token& at, std::string message);
    bool failed() const { return failed_; }
    void warn(const Token& at, std::string message);
    void warn_once(std::string_view key, const Token& at, std::string message);
    std::string_view text_of(const Token& token) const;
    SourcePlace place_of(const Token& token);
    /// Of the outermost macro call that is being read, or `at`.
    Token call_place(const Token& at) const;
    /// Of the text itself, without its includes.
    std::span<const Token> own_tokens() const { return tokens_[text_.file]; }

    // Limits. What returns false beyond one: with an error, but for count_shapes().

    bool spend(std::uint64_t steps = 1);
    bool is_within_memory(const Token& at);
    /// Whether the memory has room for these bytes in addition.
    bool has_room(std::uint64_t bytes, const Token& at);
    /// A long loop that makes shapes is none that does not end.
    void allow_steps(std::uint64_t shapes);
    std::uint64_t max_shapes() const { return k_max_shapes + own_tokens().size(); }
    std::uint64_t shapes() const { return shapes_; }
    bool count_shapes(std::uint64_t more) { return (shapes_ += more) <= max_shapes(); }

  protected:
    LoadState& reading() const { return reading_; }
    const ReadText& text() const { return text_; }
    /// Before the first token.
    void begin();

    // Tokens.

    const Token& peek() {
        if (!has_ahead_) fetch();
        return ahead_;
    }
    Token take() {
        peek();
        has_ahead_ = false;
        if (ahead_.kind == TokenKind::symbol) braces_ += (ahead_.symbol == '{') - (ahead_.symbol == '}');
        return ahead_;
    }
    bool accept(char symbol) {
        if (!peek().is(symbol)) return false;
        take();
        return true;
    }
    bool accept(Word word) {
        if (peek().word() != word) return false;
        has_ahead_ = false;
        return true;
    }
    bool expect(char symbol);
    /// An error about the next token.
    void expected(std::string_view what);
    std::string describe(const Token& token) const;
    /// ", ..." of a word that stands for nothing here.
    std::string what_is(const Token& token);
    /// The text of a list that was taken. False after an error.
    bool list_text(const Token& list, std::string_view& text);
    /// The last token that was taken.
    const Token& taken() const { return ahead_; }
    // The tokens of this frame as they are written: the next one, not after peek(); and those after peek().
    Token take_raw();
    bool has_raw(std::uint32_t skipped = 0) const { return frames_.back().at + skipped < frames_.back().end; }
    const Token& raw(std::uint32_t skipped = 0) const {
        return frames_.back().tokens[frames_.back().at + skipped];
    }
    /// Counts blocks, brackets and calls within each other; not `ok`, with an error, if there are too many.
    struct Deeper {
        explicit Deeper(TokenStream& stream);
        ~Deeper() { --stream_.nesting_; }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;
        bool ok = true;

      private:
        TokenStream& stream_;
    };

    // Names.

    std::string_view name_of(std::uint32_t number) const { return names_.name(number); }
    std::uint32_t number_of(std::string_view name);
    /// What a token stands for here; null if it is no identifier, or one without a value. Until the next
    /// token.
    const Value* find_value(const Token& token);
    std::uint32_t depth() const { return static_cast<std::uint32_t>(frames_.size() - 1); }
    /// The binding of a name as a frame sees it. `name` becomes that of the target of references.
    Binding* find_binding(std::uint32_t& name, std::uint32_t depth);
    /// What #declare (or #local) at this depth does.
    void assign(std::uint32_t name, bool is_local, std::uint32_t at_depth, Value value);
    void assign(std::uint32_t name, bool is_local, Value value) {
        assign(name, is_local, depth(), std::move(value));
    }
    /// An error if macros and includes are too deep within each other.
    bool can_call(const Token& name);
    /// Reads the tokens of a function next, with these values of its parameters.
    void enter(const Token& name, const std::shared_ptr<const Function>& function,
               std::span<const double> values);

  private:
    bool is_reference(std::uint32_t name, std::uint32_t depth) const;

    friend class DirectiveParser;  // which moves in the frames

    /// Carries out a directive whose word is `at`.
    virtual void read_directive(const Token& at) = 0;
    /// Opens the macro's frame; its name has been read.
    virtual void call_macro(const Token& name, const Macro& macro) = 0;

    bool refuse_memory(const Token& at);
    void fetch();
    void set_end();
    void lex_text(std::uint16_t number);
    bool at_end_of_frame() const { return frames_.back().at >= frames_.back().end; }
    bool check_end_of_text();
    void leave_frame();
    bool is_marked() const {
        return !marks_.empty() && marks_.back().frames == frames_.size() && marks_.back().braces == braces_;
    }
    bool ends_value(Word directive) const;
    void begin_value() { marks_.push_back({frames_.size(), conditions_.size(), braces_}); }
    void end_value();

    Reference target_of(Reference reference);
    void bind(std::uint32_t name, std::uint32_t depth, Value value);
    void unbind(std::uint32_t name);
    void declare_numbers();

    LoadState& reading_;
    const ReadText& text_;
    Names names_;
    std::map<std::uint16_t, CountedVector<std::uint32_t>> line_starts_;
    std::vector<CountedVector<Token>> tokens_;  // by the number of the text
    std::vector<LexError> lex_errors_;
    std::vector<Frame> frames_;
    CountedVector<Condition> conditions_;
    std::vector<Mark> marks_;
    CountedVector<CountedVector<Binding>> bindings_;  // by name, innermost last
    Token ahead_;
    bool has_ahead_ = false, failed_ = false;
    std::uint64_t max_steps_ = k_max_steps;  // and one for each token of the text
    std::uint64_t steps_ = 0, shapes_ = 0, list_bytes_ = 0;
    int nesting_ = 0, braces_ = 0;
};

}  // namespace glint::povray
