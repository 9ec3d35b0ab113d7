#pragma once
// The scene that stands beside pictures: `--scene FILE` and how it is drawn.
#include <optional>

#include "cli/scene_arguments.h"

namespace glint::cli {

struct SceneOption {
    SceneArguments scene;  ///< no files: no scene was given
    std::string shading, reflections, aa;
    bool no_shadows = false;
};

/// Adds --scene FILE, --scene-name and render's options of how the scene is drawn.
void add_scene_option(CLI::App& command, SceneOption& option, const char* description);

/// Hands the options of how the scene is drawn to its arguments, before load_scene.
void take_settings(SceneOption& option);

/// The scene, with its warnings printed unless `quiet`; nothing if none was given. Throws Failure as
/// load_scene does.
std::optional<LoadedScene> load_scene_option(SceneOption& option, bool quiet);

}  // namespace glint::cli
