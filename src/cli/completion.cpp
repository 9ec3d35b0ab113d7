// glint completion bash: a script made from the commands' own options, so that it cannot be behind them.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/validators.h"
#include "glint/glint.h"

namespace glint::cli {
namespace {

std::string option_words(const CLI::App& command) {
    std::string words;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) words += (words.empty() ? "--" : " --") + name;
        for (const std::string& name : option->get_snames()) words += " -" + name;
    }
    return words;
}

std::string script(const CLI::App& app) {
    std::string commands, options;
    for (const CLI::App* command : app.get_subcommands({})) {
        commands += (commands.empty() ? "" : " ") + command->get_name();
        options += fmt::format("        {}) options='{}' ;;\n", command->get_name(), option_words(*command));
    }
    std::string format_names, extensions, conventions;
    for (const FormatInfo& format : formats()) {
        format_names += fmt::format(" {}", format.name);
        extensions += fmt::format(" {}", format.extensions);
    }
    for (const SettingKey& key : setting_keys()) conventions += fmt::format(" {}=", key.name);
    return fmt::format(R"(# bash completion for glint, printed by `glint completion bash`
_glint() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} options='' words='' pictures=''
    COMPREPLY=()
    if [[ $COMP_CWORD == 1 ]]; then
        mapfile -t COMPREPLY < <(compgen -W '{commands} --help --version' -- "$word")
        return
    fi
    case $command in
{options}    esac
    [[ $command == compare || $command == grade ]] && pictures=1
    case $before in
        --shading) words='phong blinn-phong diffuse color normals' ;;
        --transfer) words='none srgb' ;;
        --bits) words='8 16' ;;
        --format) words='{formats}' ;;
        --profile) words='{profiles}' ;;
        --convention) words='{conventions}'; compopt -o nospace 2>/dev/null ;;
        --isa) [[ $command == render ]] && words=$(glint info --isa 2>/dev/null) ;;
        completion) words='bash' ;;
        --scene) [[ $pictures ]] || return ;;
        -s|--size|--crop|--reflections|--aa|-t|--threads|--scene-name|--within|--fail-percent|--hard-fail) return ;;
    esac
    if [[ -n $words && $word != -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
        [[ $before == --profile ]] && mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$word")
    elif [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    else
        local file ending
        compopt -o filenames 2>/dev/null
        while IFS= read -r file; do
            if [[ -d $file || $pictures || $before == -o || $before == --output || $before == --stats ]]; then
                COMPREPLY+=("$file")
            else
                for ending in{extensions}; do
                    [[ $file == *"$ending" ]] && COMPREPLY+=("$file")
                done
            fi
        done < <(compgen -f -- "$word")
    fi
}}
complete -F _glint glint
)",
                       fmt::arg("commands", commands), fmt::arg("options", options),
                       fmt::arg("formats", format_names),
                       fmt::arg("profiles", fmt::join(profile_names(), " ")),
                       fmt::arg("conventions", conventions), fmt::arg("extensions", extensions));
}

}  // namespace

Run add_completion(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("completion", "Print a completion script for the shell");
    const auto shell = std::make_shared<std::string>();
    command.add_option("SHELL", *shell, "bash")->required()->check(one_of({"bash"}));
    command.footer("Examples:\n  source <(glint completion bash)");
    return [&app, shell] {  // the option writes to it when the arguments are parsed
        fmt::print("{}", script(app));
        return k_done;
    };
}

}  // namespace glint::cli
