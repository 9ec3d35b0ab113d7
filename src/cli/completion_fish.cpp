// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/completion.h"

namespace glint::cli {
namespace {

std::string quoted_text(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') out += '\\';
        out += c;
    }
    return out + "'";
}

// The options of `complete` for the possible values.
std::string value_options(const Completed& value) {
    switch (value.kind) {
        case Completed::Kind::none:
            return {};
        case Completed::Kind::text:
            return " -x";
        case Completed::Kind::words:
        case Completed::Kind::keys:
            return fmt::format(" {} -a '{}'", value.or_file ? "-r -F" : "-x", fmt::join(value.words, " "));
        case Completed::Kind::isa:
            return " -x -a '(glint info --isa 2>/dev/null)'";
        case Completed::Kind::scene:
        case Completed::Kind::file:
            return " -r -F";
        case Completed::Kind::folder:
            return " -x -a '(__fish_complete_directories)'";
    }
    return {};
}

// The same for a positional argument, which needs no -r or -x.
std::string argument_options(const Completed& value) {
    if (value.kind == Completed::Kind::scene || value.kind == Completed::Kind::file) return " -F";
    const std::string text = value_options(value);
    const std::size_t words = text.find(" -a ");
    return words == std::string::npos ? "" : text.substr(words);
}

}  // namespace

std::string fish_completion(const CLI::App& app) {
    std::string text =
        "# fish completion for glint, printed by `glint completion fish`\n"
        "complete -c glint -f\n"
        "complete -c glint -n __fish_use_subcommand -l help -d 'Print this help'\n"
        "complete -c glint -n __fish_use_subcommand -l version -d 'Print the version'\n";
    for (const CLI::App* command : shown_commands(app)) {
        text += fmt::format("complete -c glint -n __fish_use_subcommand -a {} -d {}\n", command->get_name(),
                            quoted_text(command->get_description()));
    }
    for (const CLI::App* command : shown_commands(app)) {
        const std::string start =
            fmt::format("complete -c glint -n '__fish_seen_subcommand_from {}'", command->get_name());
        for (const CLI::Option* option : command->get_options()) {
            const Completed value = completed(app, *option);
            if (option->get_positional()) {
                const std::string options = argument_options(value);
                if (!options.empty()) text += start + options + "\n";
                continue;
            }
            text += start;
            for (const std::string& name : option->get_snames()) text += " -s " + name;
            for (const std::string& name : option->get_lnames()) text += " -l " + name;
            text += fmt::format("{} -d {}\n", value_options(value),
                                quoted_text(first_sentence(option->get_description())));
        }
    }
    return text;
}

}  // namespace glint::cli
