// SPDX-License-Identifier: Apache-2.0
// Which directive it is; declarations, defaults and messages.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/directive_parser.h"

namespace glint::povray {

void DirectiveParser::read_directive(const Token& at) {
    const Deeper deeper(*this);
    if (!deeper.ok) return;
    switch (at.directive()) {
        case Word::k_declare:
        case Word::k_local:
            return read_declare(at.directive() == Word::k_local);
        case Word::k_macro:
            return read_macro(at);
        case Word::k_if:
            return read_if(at, condition());
        case Word::k_ifdef:
        case Word::k_ifndef:
            return read_ifdef(at, at.directive() == Word::k_ifdef);
        case Word::k_else:
            return read_else(at);
        case Word::k_elseif:
            return read_elseif(at);
        case Word::k_end:
            return read_end(at);
        case Word::k_while:
            conditions_.push_back({ConditionKind::loop_while, at, false, frames_.back().at});
            return run_while();
        case Word::k_for:
            return read_for(at);
        case Word::k_switch:
            return read_switch(at);
        case Word::k_case:
        case Word::k_range:
            return read_case(at);
        case Word::k_break:
            return read_break(at);
        case Word::k_include:
            return read_include(at);
        case Word::k_version:
            version_place_ = at;
            return read_version();
        case Word::k_default:
            return read_default();
        case Word::k_undef:
            return read_undef();
        case Word::k_error:
        case Word::k_warning:
        case Word::k_debug:
        case Word::k_render:
        case Word::k_statistics:
            return read_message(at);
        case Word::k_fopen:
            return read_fopen();
        case Word::k_write:
            return read_write();
        case Word::k_fclose:
            return read_fclose();
        default:
            error(at, "`#read` of POV-Ray's language: glint does not read other files");
    }
}

// [deprecated [once] STRING] NAME [indices] = VALUE [;]
void DirectiveParser::read_declare(bool is_local) {
    Token name = take_raw();
    if (name.kind == TokenKind::word && text_of(name) == "deprecated") {
        name = take_raw();
        if (name.kind == TokenKind::word && text_of(name) == "once") name = take_raw();
        if (name.kind == TokenKind::string) name = take_raw();
    }
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) {
        const bool is_word = name.kind == TokenKind::word;
        return error(name, fmt::format("expected a name to declare, found {}{}", describe(name),
                                       is_word ? ", a word of the language" : ""));
    }
    begin_value();
    if (peek().is('[')) {
        std::uint32_t target = name.name;
        Binding* binding = find_binding(target, depth());
        if (binding == nullptr || !std::holds_alternative<std::shared_ptr<Array>>(binding->value)) {
            error(name, fmt::format("{} is not an array", quoted(name_of(name.name))));
        } else {
            const std::vector<std::uint32_t> indices = read_indices();
            if (!failed() && expect('=')) {
                Value assigned = value();
                target = name.name;
                binding = failed() ? nullptr : find_binding(target, depth());
                if (binding) assign_element(name, binding->value, indices, std::move(assigned));
            }
        }
    } else if (expect('=')) {
        const std::uint32_t own_depth = depth();
        Value assigned = value();  // whose last token may be that of a macro, which has not been left
        if (!failed()) assign(name.name, is_local, std::min(own_depth, depth()), std::move(assigned));
    }
    if (!failed()) accept(';');
    end_value();
}

void DirectiveParser::read_undef() {
    const Token name = take_raw();
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) {
        return error(name, fmt::format("expected a name after `#undef`, found {}", describe(name)));
    }
    unbind(name.name);
}

void DirectiveParser::read_version() {
    if (peek().kind == TokenKind::word && peek().word() == Word::k_version) {
        take();  // #version version;
    } else {
        begin_value();
        const double version = number();
        if (!failed()) version_ = version;
        end_value();
    }
    accept(';');
}

// #default { items }
void DirectiveParser::read_default() {
    if (!expect('{')) return;
    while (!failed() && !accept('}')) {
        const Token item = take();
        switch (item.word()) {
            case Word::k_texture:
                default_texture() = read_texture();
                break;
            case Word::k_pigment:
                read_pigment(default_texture().pigment);
                break;
            case Word::k_finish:
                read_finish(default_texture().finish);
                break;
            case Word::k_normal:
                read_opaque(Word::k_normal, item);
                default_texture().missing.add(missing(item, "normal"));
                break;
            case Word::k_camera:
                default_camera() = read_camera(item);
                break;
            default:
                return error(item,
                             fmt::format("expected `texture`, `pigment`, `finish`, `normal`, `camera` or "
                                         "`}}`, found {}",
                                         describe(item)));
        }
    }
}

void DirectiveParser::read_message(const Token& at) {
    begin_value();
    const String text = string();
    accept(';');
    end_value();
    if (failed()) return;
    if (at.directive() == Word::k_error) {
        error(at, fmt::format("the text reports an error: {}", quoted(*text)));
    } else if (at.directive() == Word::k_warning) {
        warn(at, fmt::format("the text warns: {}", quoted(*text)));
    }
}

}  // namespace glint::povray
