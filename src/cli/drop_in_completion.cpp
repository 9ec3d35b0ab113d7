// SPDX-License-Identifier: Apache-2.0
// Completion scripts for glint-tachyon and glint-povray, from the table of their help.
#include <fmt/format.h>

#include <algorithm>

#include "cli/drop_in.h"

namespace glint::cli {
namespace {

/// A switch, without its value.
struct Switch {
    std::string name;
    std::string value;         // "FILE", "X Y"; empty: none
    bool is_attached = false;  // the value follows without a blank: +W800
    const DropInOption* option;
    bool takes_file() const { return value == "FILE" || value == "FOLDER"; }
};

std::vector<Switch> switches(const DropInProgram& program) {
    std::vector<Switch> all;
    for (const DropInOption& option : program.options) {
        for (std::string_view rest = option.names; !rest.empty();) {
            const std::size_t comma = std::min(rest.find(", "), rest.size());
            const std::string_view one = rest.substr(0, comma);
            rest.remove_prefix(std::min(comma + 2, rest.size()));
            if (one[0] != '+' && one[0] != '-') continue;  // FILE.ini
            const std::size_t end = std::min(one.find_first_of(" ["), one.size());
            Switch s{std::string(one.substr(0, end)), {}, end < one.size() && one[end] == '[', &option};
            if (end < one.size())
                s.value = one.substr(end + 1, one.size() - end - 1 - (s.is_attached ? 1u : 0u));
            all.push_back(std::move(s));
        }
    }
    return all;
}

template <class Wanted>
std::string joined(const std::vector<Switch>& all, const char* between, const Wanted& wanted) {
    std::string text;
    for (const Switch& s : all) {
        if (wanted(s)) text += (text.empty() ? "" : between) + s.name;
    }
    return text;
}

// zsh looks for a function with the file's name.
std::string function_name(const DropInProgram& program) { return fmt::format("_{}", program.name); }

// The branches of `case $before` in bash and zsh. words: the command that offers words, with {}.
std::string cases(const std::vector<Switch>& all, const std::string& words, const std::string& files) {
    std::string text;
    for (const Switch& s : all) {
        if (s.option->values.empty()) continue;
        text += fmt::format("        {}) {}; return ;;\n", s.name,
                            fmt::format(fmt::runtime(words), s.option->values));
    }
    const auto has_value = [](const Switch& s) { return !s.value.empty() && !s.is_attached; };
    const std::string of_files =
        joined(all, "|", [&](const Switch& s) { return has_value(s) && s.takes_file(); });
    if (!of_files.empty()) text += fmt::format("        {}) {} ;;\n", of_files, files);
    const std::string others = joined(all, "|", [&](const Switch& s) {
        return has_value(s) && !s.takes_file() && s.option->values.empty();
    });
    if (!others.empty()) text += fmt::format("        {}) return ;;\n", others);
    return text;
}

std::string attached_files(const std::vector<Switch>& all) {
    return joined(all, "*|", [](const Switch& s) { return s.is_attached && s.takes_file(); });
}

std::string every_switch(const std::vector<Switch>& all) {
    return joined(all, " ", [](const Switch&) { return true; });
}

std::string head(const DropInProgram& program, const char* shell) {
    return fmt::format("# {0} completion for {1}, printed by `glint completion {0} --program {1}`\n", shell,
                       program.name);
}

std::string bash(const DropInProgram& program) {
    const auto all = switches(program);
    std::string attached = attached_files(all);
    if (!attached.empty()) attached = fmt::format("        {}*) start=${{word:0:2}} ;;\n", attached);
    return head(program, "bash") +
           fmt::format(R"({function}() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} start='' endings='{extensions}' file ending
    COMPREPLY=()
    case $before in
{cases}        *) ;;
    esac
    case $word in
{attached}        [-+]*)
            [[ $word == +* ]] && compopt -o nospace 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -W '{switches}' -- "$word")
            return ;;
    esac
    compopt -o filenames 2>/dev/null
    while IFS= read -r file; do
        if [[ -d $file || -z $endings ]]; then
            COMPREPLY+=("$start$file")
            continue
        fi
        for ending in $endings; do
            [[ $file == *".$ending" ]] && COMPREPLY+=("$start$file")
        done
    done < <(compgen -f -- "${{word#"$start"}}")
}}
complete -F {function} {name}
)",
                       fmt::arg("function", function_name(program)),
                       fmt::arg("extensions", program.extensions), fmt::arg("name", program.name),
                       fmt::arg("cases", cases(all, "mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$word\")",
                                               "endings=''")),
                       fmt::arg("attached", attached), fmt::arg("switches", every_switch(all)));
}

std::string zsh(const DropInProgram& program) {
    const auto all = switches(program);
    std::string attached = attached_files(all), endings(program.extensions);
    if (!attached.empty()) attached = fmt::format("        {}*) compset -P '[+]?'; _files ;;\n", attached);
    std::replace(endings.begin(), endings.end(), ' ', '|');
    return fmt::format("#compdef {}\n", program.name) + head(program, "zsh") +
           fmt::format(R"sh({function}() {{
    case $words[CURRENT-1] in
{cases}    esac
    case $PREFIX in
{attached}        +*) compadd -S '' -- {switches} ;;
        -*) compadd -- {switches} ;;
        *) _files -g "*.({endings})" ;;
    esac
}}
if [[ $funcstack[1] == {function} ]]; then
    {function} "$@"
else
    compdef {function} {name}
fi
)sh",
                       fmt::arg("function", function_name(program)), fmt::arg("name", program.name),
                       fmt::arg("cases", cases(all, "compadd -- {}", "_files; return")),
                       fmt::arg("attached", attached), fmt::arg("switches", every_switch(all)),
                       fmt::arg("endings", endings));
}

std::string quoted_for_fish(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') out += '\\';
        out += c;
    }
    return out + "'";
}

std::string fish(const DropInProgram& program) {
    std::string text = head(program, "fish");
    for (const Switch& s : switches(program)) {
        std::string option;
        if (s.name[0] == '+' || s.is_attached) {
            option = fmt::format("-a {}", s.name);
        } else if (s.name.starts_with("--")) {
            option = fmt::format("-l {}", s.name.substr(2));
        } else {
            option = fmt::format("-{} {}", s.name.size() == 2 ? 's' : 'o', s.name.substr(1));
            if (!s.option->values.empty()) {
                option += fmt::format(" -x -a '{}'", s.option->values);
            } else if (!s.value.empty()) {
                option += s.takes_file() ? " -r -F" : " -x";
            }
        }
        text +=
            fmt::format("complete -c {} {} -d {}\n", program.name, option, quoted_for_fish(s.option->text));
    }
    return text;
}

}  // namespace

std::string drop_in_completion(const DropInProgram& program, std::string_view shell) {
    return shell == "bash" ? bash(program) : shell == "zsh" ? zsh(program) : fish(program);
}

}  // namespace glint::cli
