// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene options that all commands share.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/input_file.h"
#include "glint/glint.h"
#include "scene/validated_scene.h"

namespace glint::cli {

struct SceneArguments {
    std::vector<std::string> files;
    std::string format, scene_name, profile;
    std::vector<std::string> conventions;    // KEY=VALUE
    std::vector<std::string> include_paths;  // folders
    /// Includes only from the folders of the files and the include paths.
    bool is_confined = false;
    bool skip_unsupported = false;  ///< of LoadOptions
    std::optional<Vec3> view;       ///< of LoadOptions
    bool is_named_by_file = false;  ///< another file names the files, not the user
    std::uint64_t max_memory = 0;   // of LoadOptions
    /// Set by the command from its own options, before load_scene.
    std::vector<std::pair<std::string, std::string>> settings;
    /// Texts that follow the files, in the same format: their names and texts.
    std::vector<std::pair<std::string, std::string>> further_texts = {};
    std::vector<std::pair<std::string, double>> declared = {};  // of LoadOptions
};

/// Adds SCENE..., --format, --scene, --include-path, --max-memory, --profile and --convention.
void add_scene_arguments(CLI::App& command, SceneArguments& arguments);

/// Adds only --include-path.
void add_include_path_argument(CLI::App& command, SceneArguments& arguments);

/// Adds only --format, --profile and --convention, for commands whose scene is an option.
void add_convention_arguments(CLI::App& command, SceneArguments& arguments);

/// The names of all settings and conventions.
std::vector<std::string_view> setting_names();

struct LoadedScene {
    ValidatedScene scene;
    std::vector<Diagnostic> warnings;
    std::vector<InputFile> files;
    std::vector<SceneText> texts;  ///< one for each of `files`
    /// Name and hash of each text that these include.
    std::vector<std::pair<std::string, std::string>> included;
    FileReach reach;  ///< of these
};

/// Reads the files as one scene. Throws a usage error for a setting that is invalid for every scene. Prints
/// the errors of the scene and throws Failure (bad input).
LoadedScene load_scene(const SceneArguments& arguments, TextReader& reader);
LoadedScene load_scene(const SceneArguments& arguments);

/// The scene again, for a picture of this size; nothing if it has an error then.
std::optional<Scene> load_with_size(const SceneArguments& arguments, const LoadedScene& loaded,
                                    std::int32_t width, std::int32_t height);

/// Opens the files that the scene includes again, and adds their texts to `texts`. The texts are valid as
/// long as the returned files. A file that cannot be opened is omitted, and one
/// without a scene's name, whose lines no message quotes.
std::vector<InputFile> open_included(const LoadedScene& loaded, std::vector<SceneText>& texts);

/// Adds the warnings of prepare() that load() has not reported.
void add_warnings(std::vector<Diagnostic>& warnings, const std::vector<Diagnostic>& more);

/// Prints messages to standard error.
void print(const std::vector<Diagnostic>& diagnostics);

}  // namespace glint::cli
