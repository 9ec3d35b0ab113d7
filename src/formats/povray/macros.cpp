// SPDX-License-Identifier: Apache-2.0
// Macros: their definitions and calls.
#include <fmt/format.h>

#include "formats/povray/directive_parser.h"

namespace glint::povray {

// NAME (PARAMETERS) tokens #end. The body is parsed at each call.
void DirectiveParser::read_macro(const Token& at) {
    const Token name = take_raw();
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) {
        return error(name, fmt::format("expected the name of a macro, found {}", describe(name)));
    }
    Token token = take_raw();
    if (!token.is('(')) return error(token, fmt::format("expected `(`, found {}", describe(token)));
    auto macro = make_counted<Macro>();
    for (token = take_raw(); !token.is(')'); token = take_raw()) {
        if (token.is(',')) continue;
        if (token.kind != TokenKind::word || Names::is_reserved(token.name)) {
            return error(token,
                         fmt::format("expected the name of a parameter or `)`, found {}{}", describe(token),
                                     token.kind == TokenKind::word ? ", a word of the language" : ""));
        }
        macro->parameters.push_back(token.name);
    }
    Frame& frame = frames_.back();
    macro->text = frame.text;
    macro->begin = frame.at;
    macro->end = find_end(frame.at, frame.end);
    spend(macro->end - macro->begin);
    if (macro->end >= frame.end) return error(at, "this `#macro` has no `#end`");
    frame.at = macro->end + 1;
    assign(name.name, false, std::shared_ptr<const Macro>(std::move(macro)));
}

void DirectiveParser::call_macro(const Token& name, const Macro& macro) {
    if (!can_call(name)) return;
    const Deeper deeper(*this);
    if (!deeper.ok) return;
    CountedVector<Value> values;
    if (!expect('(')) return;
    for (std::size_t i = 0; i < macro.parameters.size() && !failed(); ++i) {
        if (i > 0) accept(',');
        const Token& token = peek();
        if (token.is(')')) {
            return error(token, fmt::format("expected {} values for {}(), found {}", macro.parameters.size(),
                                            name_of(name.name), i));
        }
        if (token.kind == TokenKind::word && !Names::is_reserved(token.name) && has_raw() &&
            (raw().is(',') || raw().is(')'))) {
            // An identifier alone: the macro may change what it stands for.
            values.emplace_back(target_of({take().name, depth()}));
        } else {
            values.push_back(value());
        }
    }
    if (failed()) return;
    if (!accept(')')) {
        return expected(
            fmt::format("`)` after the {} values of {}()", macro.parameters.size(), name_of(name.name)));
    }
    frames_.push_back({FrameKind::macro,
                       macro.text,
                       tokens_[macro.text].data(),
                       macro.begin,
                       macro.end,
                       conditions_.size(),
                       {},
                       name,
                       nullptr});
    for (std::size_t i = 0; i < values.size(); ++i) {
        bind(macro.parameters[i], depth(), std::move(values[i]));
    }
}

}  // namespace glint::povray
