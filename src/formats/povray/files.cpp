// SPDX-License-Identifier: Apache-2.0
// Files that texts write: what they would write is computed, and no file is written.
#include <fmt/format.h>

#include "base/text.h"
#include "formats/povray/directive_parser.h"

namespace glint::povray {

// NAME "file" read | write | append
void DirectiveParser::read_fopen() {
    const Token name = take_raw();
    if (name.kind != TokenKind::word || Names::is_reserved(name.name))
        return error(name, fmt::format("expected a name for the file, found {}", describe(name)));
    begin_value();
    const String file = string();
    end_value();
    if (failed()) return;
    const Token use = take_raw();
    const std::string_view word = text_of(use);
    if (word == "read") {
        return error(use, fmt::format("glint does not read other files by `#fopen`: {}", quoted(*file)));
    }
    if (word != "write" && word != "append")
        return error(use, fmt::format("expected `read`, `write` or `append`, found {}", describe(use)));
    warn_once("fopen", name,
              fmt::format("glint writes no files: `#write` to {} has no effect", quoted(*file)));
    assign(name.name, false, make_counted<const Opaque>(Opaque{Word::k_fopen, name}));
}

// Whether the name is that of an open file; else an error.
bool DirectiveParser::is_file(const Token& name) {
    const Value* const value = find_value(name);
    const auto* const held = value ? std::get_if<std::shared_ptr<const Opaque>>(value) : nullptr;
    if (held && (*held)->word == Word::k_fopen) return true;
    error(name, fmt::format("expected an open file, found {}{}", describe(name), what_is(name)));
    return false;
}

// ( NAME, items )
void DirectiveParser::read_write() {
    if (!expect('(') || !is_file(take_raw())) return;
    begin_value();
    while (!failed() && !accept(')')) {
        if (accept(',')) continue;
        const Token at = peek();
        const Value item = value();
        if (!failed() && !std::holds_alternative<Numbers>(item) && !std::holds_alternative<String>(item))
            error(at, fmt::format("expected a text, a number or a vector, found {}", povray::describe(item)));
    }
    end_value();
}

void DirectiveParser::read_fclose() {
    const Token name = take_raw();
    if (is_file(name)) unbind(name.name);
}

}  // namespace glint::povray
