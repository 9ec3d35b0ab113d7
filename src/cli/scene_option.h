// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene of commands whose arguments are pictures: `--scene FILE` and its options.
#include <optional>

#include "cli/picture_arguments.h"

namespace glint::cli {

struct SceneOption {
    SceneArguments scene;  ///< no files if no scene was given
    PictureArguments picture;
};

/// Adds --scene FILE, --scene-name and the options for rendering the scene.
void add_scene_option(CLI::App& command, SceneOption& option, const char* description);

/// Loads the scene; prints its warnings unless `quiet`. Returns nothing if no scene was given. Throws the
/// errors of load_scene.
std::optional<LoadedScene> load_scene_option(SceneOption& option, bool quiet);

}  // namespace glint::cli
