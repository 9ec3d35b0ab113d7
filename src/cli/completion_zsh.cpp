// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/completion.h"

namespace glint::cli {
namespace {

// Escapes text for single quotes and for the brackets or colons in a specification of _arguments.
std::string escaped(const std::string& text, const char* special) {
    std::string out;
    for (const char c : text) {
        if (c == '\'') {
            out += "'\\''";
            continue;
        }
        if (std::string_view(special).find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

// ":NAME:ACTION" of _arguments; empty for a flag.
std::string value_spec(const Completed& value, const std::string& name) {
    std::string action = " ";
    switch (value.kind) {
        case Completed::Kind::none:
            return {};
        case Completed::Kind::text:
            break;
        case Completed::Kind::words:
            action = value.or_file ? fmt::format("{{compadd -- {}; _files}}", fmt::join(value.words, " "))
                                   : fmt::format("({})", fmt::join(value.words, " "));
            break;
        case Completed::Kind::keys:
            action = fmt::format("{{compadd -S \"\" -- {}}}", fmt::join(value.words, " "));
            break;
        case Completed::Kind::isa:
            action = "{compadd -- $(glint info --isa 2>/dev/null)}";
            break;
        case Completed::Kind::scene: {
            std::string endings;
            for (const std::string& extension : scene_extensions())
                endings += (endings.empty() ? "" : "|") + extension.substr(1);
            action = fmt::format("_files -g \"*.({})\"", endings);
            break;
        }
        case Completed::Kind::file:
            action = "_files";
            break;
        case Completed::Kind::folder:
            action = "_files -/";
            break;
    }
    return fmt::format(":{}:{}", escaped(name, ":"), action);
}

std::string option_spec(const CLI::App& app, const CLI::Option& option) {
    const Completed value = completed(app, option);
    if (option.get_positional()) {
        return fmt::format("'{}{}'", option.get_items_expected_max() > 1 ? "*" : "",
                           value_spec(value, option.get_name()));
    }
    const auto names = dashed_names(option);
    const std::string text = fmt::format("[{}]{}", escaped(first_sentence(option.get_description()), "[]\\"),
                                         value_spec(value, option.get_option_text()));
    if (is_repeated(option)) return fmt::format("'*{}{}'", names.front(), text);
    if (names.size() == 1) return fmt::format("'{}{}'", names.front(), text);
    return fmt::format("'({})'{{{}}}'{}'", fmt::join(names, " "), fmt::join(names, ","), text);
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
    std::string commands, cases;
    for (const CLI::App* command : shown_commands(app)) {
        commands += fmt::format("            '{}:{}'\n", command->get_name(),
                                escaped(command->get_description(), ":\\"));
        std::string specs;
        for (const CLI::Option* option : command->get_options())
            specs += " \\\n                " + option_spec(app, *option);
        cases += fmt::format("        {})\n            _arguments{} ;;\n", command->get_name(), specs);
    }
    return fmt::format(R"(#compdef glint
# zsh completion for glint, printed by `glint completion zsh`
_glint() {{
    if (( CURRENT == 2 )); then
        local -a commands=(
{}        )
        _describe -t commands command commands
        [[ $PREFIX == -* ]] && compadd -- --help --version
        return
    fi
    local curcontext=$curcontext
    shift words
    (( CURRENT-- ))
    case $words[1] in
{}    esac
}}
if [[ $funcstack[1] == _glint ]]; then
    _glint "$@"
else
    compdef _glint glint
fi
)",
                       commands, cases);
}

}  // namespace glint::cli
