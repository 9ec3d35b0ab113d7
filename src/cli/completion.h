// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a shell completes, from the commands' own options, and its scripts.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace glint::cli {

/// What may stand where an option has its value, or an argument.
struct Completed {
    enum class Kind {
        none,   ///< a flag: no value
        text,   ///< anything, of which nothing is known
        words,  ///< one of `words`; and a file, if `or_file`
        keys,   ///< one of `words`, each ends in '=' and goes on
        isa,    ///< what `glint info --isa` prints
        scene,  ///< a file whose name ends in one of scene_extensions()
        file,
        folder,
    };
    Kind kind = Kind::none;
    std::vector<std::string> words;
    bool or_file = false;
};

/// By the option's text in the help: "none|srgb", "OUT.png", "KEY=VALUE".
Completed completed(const CLI::App& app, const CLI::Option& option);

/// With their dots.
std::vector<std::string> scene_extensions();

/// "-s", "--size".
std::vector<std::string> dashed_names(const CLI::Option& option);

/// Whether it may be given again.
bool is_repeated(const CLI::Option& option);

/// A description up to its first full stop or semicolon outside parentheses: a line in a list.
std::string first_sentence(const std::string& description);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

}  // namespace glint::cli
