// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/completion.h"

namespace glint::cli {
namespace {

// The bash commands that complete the word after an option.
std::string action(const Completed& value) {
    switch (value.kind) {
        case Completed::Kind::none:
            return {};
        case Completed::Kind::text:
            return "return";
        case Completed::Kind::words:
            return fmt::format("words='{}'{}", fmt::join(value.words, " "),
                               value.or_file ? " kind=file" : "");
        case Completed::Kind::keys:
            return fmt::format("words='{}'; compopt -o nospace 2>/dev/null", fmt::join(value.words, " "));
        case Completed::Kind::isa:
            return "words=$(glint info --isa 2>/dev/null)";
        case Completed::Kind::scene:
            return "kind=scene";
        case Completed::Kind::file:
            return "kind=file";
        case Completed::Kind::folder:
            return "kind=folder";
    }
    return {};
}

std::string command_case(const CLI::App& app, const CLI::App& command) {
    std::string options, cases, argument = "return";
    for (const CLI::Option* option : command.get_options()) {
        const std::string does = action(completed(app, *option));
        if (option->get_positional()) {
            argument = does;
            continue;
        }
        const auto names = dashed_names(*option);
        options += fmt::format("{}{}", options.empty() ? "" : " ", fmt::join(names, " "));
        if (!does.empty()) cases += fmt::format("                {}) {} ;;\n", fmt::join(names, "|"), does);
    }
    return fmt::format(
        "        {})\n            options='{}'\n            [[ $word == -* ]] || case $before in\n{}         "
        "       *) {} ;;\n"
        "            esac ;;\n",
        command.get_name(), options, cases, argument);
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
    std::string names, cases, extensions;
    for (const CLI::App* command : shown_commands(app)) {
        names += command->get_name() + " ";
        cases += command_case(app, *command);
    }
    for (const std::string& extension : scene_extensions()) extensions += " " + extension;
    return fmt::format(R"(# bash completion for glint, printed by `glint completion bash`
_glint() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}}
    local options='' words='' kind=''
    COMPREPLY=()
    if [[ $COMP_CWORD == 1 ]]; then
        mapfile -t COMPREPLY < <(compgen -W '{names}--help --version' -- "$word")
        return
    fi
    case $command in
{cases}    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
        return
    fi
    [[ -n $words ]] && mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    [[ -z $kind ]] && return
    local file ending
    compopt -o filenames 2>/dev/null
    while IFS= read -r file; do
        if [[ -d $file || $kind == file ]]; then
            COMPREPLY+=("$file")
        elif [[ $kind == scene ]]; then
            for ending in{extensions}; do
                [[ $file == *"$ending" ]] && COMPREPLY+=("$file")
            done
        fi
    done < <(compgen -f -- "$word")
}}
complete -F _glint glint
)",
                       fmt::arg("names", names), fmt::arg("cases", cases),
                       fmt::arg("extensions", extensions));
}

}  // namespace glint::cli
