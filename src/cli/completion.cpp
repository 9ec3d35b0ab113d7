// SPDX-License-Identifier: Apache-2.0
// glint completion: scripts generated from the commands' options, so that they are always up to date.
#include "cli/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "cli/commands.h"
#include "cli/drop_in.h"
#include "cli/failure.h"
#include "cli/scene_arguments.h"
#include "cli/validators.h"
#include "glint/glint.h"

namespace glint::cli {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> words;
    std::istringstream in(text);
    for (std::string word; std::getline(in, word, at);) words.push_back(word);
    return words;
}

template <class Words> std::vector<std::string> strings(const Words& words) {
    return {words.begin(), words.end()};
}

std::vector<std::string> keys(bool with_profile) {
    std::vector<std::string> all;
    for (const std::string_view name : setting_names()) all.push_back(std::string(name) + "=");
    if (with_profile) all.emplace_back("profile=");
    return all;
}

}  // namespace

Completed completed(const CLI::App& app, const CLI::Option& option) {
    using Kind = Completed::Kind;
    const std::string& text = option.get_option_text();
    const std::string name = option.get_name();
    if (option.get_items_expected_max() == 0) return {};
    if (text == "NAME|FILE") return {Kind::words, strings(profile_names()), true};
    if (text.find('|') != std::string::npos) return {Kind::words, split(text, '|')};
    if (text.starts_with("KEY=")) return {Kind::keys, keys(name == "--a" || name == "--b")};
    if (text == "LAYERS") {
        Completed layers{Kind::words, {"all"}};
        for (const LayerInfo& info : layer_infos()) layers.words.emplace_back(info.name);
        return layers;
    }
    if (name == "--isa") return {Kind::isa, {}};
    if (name == "SCENE") return {Kind::scene, {}};
    if (name == "DIR") return {Kind::folder, {}};
    if (name == "COMMAND") {
        Completed commands{Kind::words, {}};
        for (const CLI::App* command : shown_commands(app)) commands.words.push_back(command->get_name());
        return commands;
    }
    if (name == "--scene" && text == "FILE") return {Kind::scene, {}};
    const auto starts = [&](const char* word) { return text.starts_with(word); };
    if (name == "FILE" || starts("FILE") || starts("OUT") || starts("PICTURE")) return {Kind::file, {}};
    return {Kind::text, {}};
}

std::vector<std::string> scene_extensions() {
    std::vector<std::string> all;
    for (const FormatInfo& format : formats()) {
        for (std::string& extension : split(std::string(format.extensions), ' ')) {
            if (std::find(all.begin(), all.end(), extension) == all.end())
                all.push_back(std::move(extension));
        }
    }
    return all;
}

std::vector<std::string> dashed_names(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

bool is_repeated(const CLI::Option& option) {
    return option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

std::string first_sentence(const std::string& description) {
    int open = 0;  // parentheses
    for (std::size_t i = 0; i + 1 < description.size(); ++i) {
        const char c = description[i];
        open += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (open == 0 && (c == '.' || c == ';') && description[i + 1] == ' ') return description.substr(0, i);
    }
    return description;
}

Run add_completion(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("completion", "Print a completion script for the shell");
    const auto shell = std::make_shared<std::string>();
    command.add_option("SHELL", *shell, "The shell")
        ->required()
        ->check(one_of({"bash", "zsh", "fish"}))
        ->option_text("bash|zsh|fish");
    const auto program = std::make_shared<std::string>();
    command.add_option("--program", *program, "The program whose script it is; default: glint")
        ->check(one_of({"glint", "glint-povray", "glint-tachyon"}))
        ->option_text("glint|glint-povray|glint-tachyon");
    command.footer(
        "Examples:\n"
        "  source <(glint completion bash)\n"
        "  source <(glint completion zsh)\n"
        "  glint completion fish | source");
    return [&app, shell, program] {  // they are set when the arguments are parsed
        if (const DropInProgram* other = find_drop_in(*program)) {
            fmt::print("{}", drop_in_completion(*other, *shell));
            return k_done;
        }
        fmt::print("{}", *shell == "bash"  ? bash_completion(app)
                         : *shell == "zsh" ? zsh_completion(app)
                                           : fish_completion(app));
        return k_done;
    };
}

}  // namespace glint::cli
