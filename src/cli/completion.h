// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a shell completes, derived from the commands' options, and the scripts for the shells.
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace glint::cli {

/// The possible values of an option or a positional argument.
struct Completed {
    enum class Kind {
        none,   ///< a flag: no value
        text,   ///< any text; nothing is completed
        words,  ///< one of `words`, or a file if `or_file`
        keys,   ///< one of `words`; each ends in '=' and is followed by a value
        isa,    ///< what `glint info --isa` prints
        scene,  ///< a file whose name ends in one of scene_extensions()
        file,
        folder,
    };
    Kind kind = Kind::none;
    std::vector<std::string> words;
    bool or_file = false;
};

/// Derived from the option's text in the help: "none|srgb", "OUT.png", "KEY=VALUE".
Completed completed(const CLI::App& app, const CLI::Option& option);

/// The extensions of scene files, with their dots.
std::vector<std::string> scene_extensions();

/// All names of an option with their dashes: "-s", "--size".
std::vector<std::string> dashed_names(const CLI::Option& option);

/// Whether the option may be given more than once.
bool is_repeated(const CLI::Option& option);

/// The description up to the first full stop or semicolon outside parentheses, for one line of a list.
std::string first_sentence(const std::string& description);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

}  // namespace glint::cli
