// SPDX-License-Identifier: Apache-2.0
// A scene whose texts are in memory, one including another, rendered to scene_in_memory.png. Programs can
// read scenes from an archive or a database in the same way.
#include <glint/glint.h>

#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace {

// The texts for `include`, by the names in the including text.
struct Texts : glint::Sources {
    std::map<std::string, std::string, std::less<>> texts;

    glint::Result<std::string> read(std::string_view name, std::string_view /*from*/) override {
        const auto found = texts.find(name);
        if (found != texts.end()) return found->second;
        return glint::Status{glint::ErrorCode::io, "there is no such text", {}};
    }
};

constexpr std::string_view k_scene = R"(
include "materials.glint"
camera { position = (0, 1, 6)  look_at = (0, 0, 0) }
light { position = (3, 5, 4) }
plane { point = (0, -1, 0)  normal = (0, 1, 0) }
sphere { center = (0, 0, 0)  radius = 1  material = red }
)";

}  // namespace

int main(int argc, char**) {
    Texts sources;
    if (argc == 1)  // with an argument the text is missing: to see an error
        sources.texts["materials.glint"] = "material red { color = (0.8, 0.1, 0.1)  mirror = 0.2 }\n";
    const glint::SceneText text{.name = "scene.glint", .text = k_scene, .format = "glint"};
    const auto scene = glint::load({&text, 1}, {.settings = {{"size", "320x240"}}}, &sources);
    std::cerr << to_string(scene);  // errors with their places; else warnings, if there are any
    if (!scene) return 1;

    const auto world = glint::prepare(*scene);
    if (!world) return 1;
    const auto png = glint::encode(glint::render(*world).value().image).value();
    std::ofstream file("scene_in_memory.png", std::ios::binary);
    file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    std::cout << "scene_in_memory.png: " << png.size() << " bytes\n";
}
