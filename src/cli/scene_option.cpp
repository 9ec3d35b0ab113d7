// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_option.h"

#include "cli/repeated_option.h"

namespace glint::cli {

void add_scene_option(CLI::App& command, SceneOption& option, const char* description) {
    repeated(command.add_option("--scene", option.scene.files, description))->option_text("FILE");
    command.add_option("--scene-name", option.scene.scene_name, "The scene to use, if the file has several")
        ->option_text("NAME");
    add_include_path_argument(command, option.scene);
    add_convention_arguments(command, option.scene);
    add_picture_arguments(command, option.picture);
}

std::optional<LoadedScene> load_scene_option(SceneOption& option, bool quiet) {
    if (option.scene.files.empty()) return std::nullopt;
    add_settings(option.picture, PictureMemory::whole, option.scene);
    LoadedScene loaded = load_scene(option.scene);
    if (!quiet) print(loaded.warnings);
    return loaded;
}

}  // namespace glint::cli
