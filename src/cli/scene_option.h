// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene that stands beside pictures: `--scene FILE` and how it is drawn.
#include <optional>

#include "cli/picture_arguments.h"

namespace glint::cli {

struct SceneOption {
    SceneArguments scene;  ///< no files: no scene was given
    PictureArguments picture;
};

/// Adds --scene FILE, --scene-name and the options of how the scene is drawn.
void add_scene_option(CLI::App& command, SceneOption& option, const char* description);

/// The scene, with its warnings printed unless `quiet`; nothing if none was given. Throws Failure as
/// load_scene does.
std::optional<LoadedScene> load_scene_option(SceneOption& option, bool quiet);

}  // namespace glint::cli
