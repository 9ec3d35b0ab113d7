// SPDX-License-Identifier: Apache-2.0
#include "formats/json_tree.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"
#include "formats/parser.h"
#include "formats/tokenizer.h"

namespace glint {

double JsonValue::number() const { return exists() ? tree_->node(node_).number : 0; }
std::size_t JsonValue::offset() const { return exists() ? tree_->node(node_).offset : 0; }
std::size_t JsonValue::length() const { return exists() ? tree_->node(node_).length : 0; }
std::uint32_t JsonValue::line() const { return exists() ? tree_->node(node_).line : 1; }
std::uint32_t JsonValue::column() const { return exists() ? tree_->node(node_).column : 1; }
std::uint32_t JsonValue::size() const { return exists() ? tree_->node(node_).count : 0; }

std::string_view JsonValue::text() const {
    return exists() ? tree_->where().text.substr(offset(), length()) : std::string_view();
}

std::string JsonValue::string() const { return is(JsonKind::string) ? string_value(text()) : std::string(); }

std::string JsonValue::description() const {
    if (!exists()) return "nothing";
    if (is(JsonKind::list)) return "a list";
    return is(JsonKind::object) ? "an object" : quoted(text());
}

JsonValue JsonValue::find(std::string_view key) const {
    JsonValue found;
    for_each_member([&](JsonValue member, JsonValue value) {
        const std::string_view written = member.text();
        const bool is_it = written.find('\\') == std::string_view::npos
                               ? written.substr(1, written.size() - 2) == key
                               : member.string() == key;
        if (is_it) found = value;  // of several, the last one
    });
    return found;
}

class JsonReader {
  public:
    JsonReader(Diagnostics& diagnostics, InputText where, std::size_t offset, std::size_t length)
        : diagnostics_(diagnostics),
          where_(where),
          base_(offset),
          start_(line_column(where.text, offset)),
          tokenizer_(where.text.substr(offset, length), Dialect{}),
          tree_(where) {}

    std::optional<JsonTree> read() {
        const std::string_view text = where_.text.substr(base_);
        if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
            token_.offset = base_;
            error("expected UTF-8, found UTF-16");
            return std::nullopt;
        }
        if (!advance() || !read_value(0)) return std::nullopt;
        if (token_.kind == TokenKind::end) return std::move(tree_);
        expected("the end of the text");
        return std::nullopt;
    }

  private:
    // False after an error in the token itself.
    bool advance() {
        constexpr std::uint32_t k_tokens = 4096;
        if (++tokens_ % k_tokens == 0 && !diagnostics_.go_on(where_, token_.offset)) return false;
        token_ = tokenizer_.next();
        if (token_.line == 1) token_.column += start_.column - 1;
        token_.line += start_.line - 1;
        token_.offset += base_;
        switch (token_.kind) {
            case TokenKind::open_string:
                return error("expected a closing quote before the end of the line");
            case TokenKind::bad_byte:
                return error(fmt::format("expected text, found the byte 0x{:02x}",
                                         static_cast<unsigned char>(where_.text[token_.offset])));
            default:
                return true;
        }
    }
    bool error(std::string message) {
        diagnostics_.error(where_, token_.offset, token_.length, std::move(message));
        return false;
    }
    bool expected(std::string_view what) {
        return error(fmt::format("expected {}, found {}", what,
                                 token_.kind == TokenKind::end ? "the end of the text" : quoted(text())));
    }
    std::string_view text() const { return where_.text.substr(token_.offset, token_.length); }

    std::uint32_t add(JsonKind kind, double number = 0) {
        const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
        JsonTree::Node node;
        node.kind = kind;
        node.line = token_.line;
        node.column = token_.column;
        node.offset = token_.offset;
        node.length = token_.length;
        node.number = number;
        node.end = index + 1;
        tree_.nodes_.push_back(node);
        return index;
    }

    bool read_value(int depth) {
        if (token_.is('{') || token_.is('[')) return read_brackets(depth);
        if (token_.kind == TokenKind::number) {
            add(JsonKind::number, token_.number);
        } else if (token_.kind == TokenKind::string) {
            add(JsonKind::string);
        } else if (token_.kind == TokenKind::word && text() == "null") {
            add(JsonKind::null);
        } else if (token_.kind == TokenKind::word && (text() == "true" || text() == "false")) {
            add(JsonKind::boolean, text() == "true" ? 1 : 0);
        } else {
            return expected(depth == 0 ? "`{`" : "a value");
        }
        return advance();
    }

    bool read_brackets(int depth) {
        if (depth == k_max_nesting)
            return error(fmt::format("brackets are nested more than {} deep", k_max_nesting));
        const bool is_object = token_.is('{');
        const char close = is_object ? '}' : ']';
        const std::uint32_t index = add(is_object ? JsonKind::object : JsonKind::list);
        const std::uint32_t line = token_.line;
        std::uint32_t count = 0;
        if (!advance()) return false;
        while (!token_.is(close)) {
            if (count > 0 && (!expect(',', close, line) || !advance())) return false;
            if (is_object && !read_key(count, line)) return false;
            if (!read_value(depth + 1)) return false;
            ++count;
        }
        tree_.nodes_[index].count = count;
        tree_.nodes_[index].end = static_cast<std::uint32_t>(tree_.nodes_.size());
        return advance();
    }
    bool read_key(std::uint32_t count, std::uint32_t line) {
        if (token_.kind != TokenKind::string) {
            if (token_.kind == TokenKind::end) return has_no_end('}', line);
            return expected(count == 0 ? "a key in quotes or `}`" : "a key in quotes");
        }
        add(JsonKind::string);
        if (!advance()) return false;
        if (!token_.is(':')) return expected("`:`");
        return advance();
    }
    bool expect(char symbol, char close, std::uint32_t line) {
        if (token_.is(symbol)) return true;
        if (token_.kind == TokenKind::end) return has_no_end(close, line);
        return expected(fmt::format("`{}` or `{}`", symbol, close));
    }
    bool has_no_end(char close, std::uint32_t line) {
        return expected(fmt::format("`{}`: the {} that begins in line {} has no end", close,
                                    close == '}' ? "object" : "list", line));
    }

    Diagnostics& diagnostics_;
    InputText where_;
    std::size_t base_;  // where the JSON begins in the text
    LineColumn start_;
    Tokenizer tokenizer_;
    JsonTree tree_;
    Token token_;
    std::uint32_t tokens_ = 0;
};

std::optional<JsonTree> read_json(Diagnostics& diagnostics, InputText where, std::size_t offset,
                                  std::size_t length) {
    return JsonReader(diagnostics, where, offset, length).read();
}

}  // namespace glint
