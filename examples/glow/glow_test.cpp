// SPDX-License-Identifier: Apache-2.0
// Renders with the field of materials that was added.
#include <cstdio>

#include "glint/glint.h"

namespace {

int failures = 0;
void expect(bool good, const char* what) {
    if (good) return;
    ++failures;
    std::printf("%s\n", what);
}

constexpr const char* k_scene =
    "render { size = 3 x 3 }\n"
    "camera { position = (0, 0, 5) }\n"
    "light { type = ambient  intensity = 0.5 }\n"
    "sphere { center = (0, 0, 0)  radius = 1  color = (1, 1, 1)  ambient = 0.5  glow = (0.5, 0.125, 0) }\n";

glint::Result<glint::Scene> load(const std::string& scene) {
    const glint::SceneText text{"glow.glint", scene, ""};
    return glint::load({&text, 1});
}

}  // namespace

int main() {
    const glint::Result<glint::Scene> loaded = load(k_scene);
    expect(loaded.has_value(), "read from .glint");
    if (!loaded) return 1;
    const glint::Result<glint::World> prepared = glint::prepare(*loaded);
    expect(prepared.has_value(), "prepared");
    if (!prepared) return 1;
    for (const std::string& isa : glint::isa_names()) {
        glint::RenderOptions options;
        options.isa = isa;
        const glint::Result<glint::Rendering> result = glint::render(*prepared, options);
        const float* middle = result ? &result->image.rgb[3 * 4] : nullptr;
        expect(middle != nullptr && middle[0] == 0.75f && middle[1] == 0.375f && middle[2] == 0.25f,
               "k_a I_a + glow");
    }
    const glint::Result<glint::Scene> again = load(glint::write_glint(*loaded).value());
    expect(again && again->materials.at(0).glow == glint::Color{0.5, 0.125, 0}, "written and read again");
    expect(!load("sphere { center = (0, 0, 0)  radius = 1  glow = (-1, 0, 0) }"), "a negative glow");
    glint::Scene broken = *loaded;
    broken.materials[0].glow.g = -1;
    const auto mistakes = glint::validate(broken);
    expect(mistakes.size() == 1 &&
               mistakes[0].message.find("glow: expected each channel to be") != std::string::npos,
           "a negative glow in code");
    std::printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}
