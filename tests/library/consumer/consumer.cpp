// SPDX-License-Identifier: Apache-2.0
// A typical user of the library: load, prepare, render, encode; and the results of bad input. Every public
// function is linked. Exits with 1 and a message if the headers' promises are broken.
#include <glint/glint.h>

#include <atomic>
#include <cstdio>
#include <string>
#include <vector>

namespace {

int failures = 0;

void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "not so: %s\n", what);
    ++failures;
}

constexpr std::string_view k_scene =
    "sphere { center = (0, -1, 3) radius = 1 color = (255, 0, 0) specular = 500 reflective = 0.2 }\n"
    "light { type = ambient intensity = 0.2 }\n"
    "light { type = point intensity = 0.6 position = (2, 1, 0) }\n";

glint::Result<glint::Scene> load(std::string_view text) {
    const std::vector<glint::SceneText> texts = {{.name = "scene.cgfs", .text = text, .format = {}}};
    return glint::load(texts, {.settings = {{"size", "64x48"}}});
}

void good_input() {
    const auto loaded = load(k_scene);
    expect(loaded.has_value() && !glint::has_errors(loaded.diagnostics), "the scene loads");
    if (!loaded) return;
    expect(!glint::has_errors(glint::validate(*loaded)), "the scene is valid");
    const auto prepared = glint::prepare(*loaded);
    expect(prepared.has_value(), "the scene is prepared");
    if (!prepared) return;
    expect(glint::memory_usage(*prepared).total() > 0, "a world takes memory");
    expect(glint::scene_bounds(*prepared).max.z >= 4, "the bounds hold the sphere");
    const auto rendered = glint::render(*prepared);
    expect(rendered && rendered->image.width == 64 && rendered->image.rgb.size() == 64 * 48 * 3, "a picture");
    expect(rendered->rays.camera == 64 * 48, "one camera ray a pixel");
    for (const std::string& isa : glint::isa_names()) {
        const auto other = glint::render(*prepared, {.threads = 1, .isa = isa});
        expect(other && rendered && other->image.rgb == rendered->image.rgb, "the same bits for every isa");
    }
    const std::atomic<bool> cancel{true};
    expect(glint::render(*prepared, {.cancel = &cancel}).code == glint::ErrorCode::cancelled,
           "a render can be cancelled");
    for (const auto format : {glint::FileFormat::png, glint::FileFormat::ppm, glint::FileFormat::exr}) {
        const auto encoded = glint::encode(rendered->image, {.format = format});
        expect(encoded && !encoded->empty(), "a picture is encoded");
    }
}

void bad_input() {
    const auto loaded = load("sphere { center = (0, oops, 3) radius = 1 color = (1, 2, 3) }\n");
    expect(!loaded && !loaded.diagnostics.empty(), "an error is reported");
    if (loaded.diagnostics.empty()) return;
    expect(loaded.diagnostics[0].line == 1 && loaded.diagnostics[0].column == 23, "with its place");
    expect(glint::to_string(loaded.diagnostics[0]).starts_with("scene.cgfs:1:23: error: "), "as text");
}

void scene_in_code() {
    glint::Scene scene;
    expect(glint::apply_profile(scene, "epfl").ok(), "there is a profile epfl");
    const auto key = glint::find_setting("specular_gate");
    expect(key.has_value(), "there is a key specular_gate");
    if (key)
        expect(glint::set_setting(scene, *key, "false", {}).ok() && !scene.conventions.specular_gate,
               "it is set");
    scene.add(glint::Sphere{.center = {0, 0, -3}, .radius = -1});
    expect(!glint::prepare(scene), "a negative radius is an error");
    expect(!glint::formats().empty() && !glint::profile_names().empty() && !glint::setting_keys().empty(),
           "lists");
}

}  // namespace

int main() {
    good_input();
    bad_input();
    scene_in_code();
    return failures == 0 ? 0 : 1;
}
