#include "cli/scene_option.h"

namespace glint::cli {

void add_scene_option(CLI::App& command, SceneOption& option, const char* description) {
    command.add_option("--scene", option.scene.files, description)
        ->option_text("FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_option("--scene-name", option.scene.scene_name, "Which scene of a file that holds several")
        ->option_text("NAME");
    add_convention_arguments(command, option.scene);
    command.add_option("--shading", option.shading, "What a surface of the scene shows")
        ->option_text("phong|blinn-phong|diffuse|color|normals");
    command.add_flag("--no-shadows", option.no_shadows, "In the scene, every light reaches everything");
    command.add_option("--reflections", option.reflections, "The scene's mirror generations, at most")
        ->option_text("N");
    command.add_option("--aa", option.aa, "The scene has N x N samples a pixel")->option_text("N");
}

void take_settings(SceneOption& option) {
    auto& settings = option.scene.settings;
    if (!option.shading.empty()) settings.emplace_back("shading", option.shading);
    if (option.no_shadows) settings.emplace_back("shadows", "false");
    if (!option.reflections.empty()) settings.emplace_back("reflections", option.reflections);
    if (!option.aa.empty()) settings.emplace_back("aa", option.aa);
}

std::optional<LoadedScene> load_scene_option(SceneOption& option, bool quiet) {
    if (option.scene.files.empty()) return std::nullopt;
    take_settings(option);
    LoadedScene loaded = load_scene(option.scene);
    if (!quiet) print(loaded.warnings);
    return loaded;
}

}  // namespace glint::cli
