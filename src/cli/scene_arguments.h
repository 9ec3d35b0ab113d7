// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the commands have in common: which scene, read how.
#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/input_file.h"
#include "glint/glint.h"

namespace glint::cli {

struct SceneArguments {
    std::vector<std::string> files;
    std::string format, scene_name, profile;
    std::vector<std::string> conventions;  // KEY=VALUE
    /// Filled by the command from its own options before load_scene.
    std::vector<std::pair<std::string, std::string>> settings;
};

/// Adds SCENE..., --format, --scene, --profile and --convention.
void add_scene_arguments(CLI::App& command, SceneArguments& arguments);

/// --format, --profile and --convention alone, for commands whose scene is an option.
void add_convention_arguments(CLI::App& command, SceneArguments& arguments);

/// Of all settings and conventions.
std::vector<std::string_view> setting_names();

struct LoadedScene {
    Scene scene;
    std::vector<Diagnostic> warnings;
    std::vector<InputFile> files;
    std::vector<SceneText> texts;  ///< of `files`
};

/// Reads the files as one scene. Throws Failure: of usage, for a setting that no scene takes; of input, after
/// printing what is wrong with it.
LoadedScene load_scene(const SceneArguments& arguments);

/// Adds the texts that the scene includes to `texts`, as far as they can be opened again; keep what is
/// returned as long as them.
std::vector<InputFile> open_included(const LoadedScene& loaded, std::vector<SceneText>& texts);

/// Adds the warnings of prepare() that load() has not given already.
void add_warnings(std::vector<Diagnostic>& warnings, const std::vector<Diagnostic>& more);

/// Prints messages to standard error.
void print(const std::vector<Diagnostic>& diagnostics);

}  // namespace glint::cli
