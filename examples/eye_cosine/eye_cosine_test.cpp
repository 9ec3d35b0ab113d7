// SPDX-License-Identifier: Apache-2.0
// Explains a pixel with the term that was added.
#include <cstdio>

#include "explain/terms.h"
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
    "plane { point = (0, 0, 0)  normal = (0, 0.6, 0.8) }\n";

}  // namespace

int main() {
    const glint::SceneText text{"plane.glint", k_scene, ""};
    const glint::Result<glint::Scene> scene = glint::load({&text, 1});
    expect(scene.has_value(), "read");
    if (!scene) return 1;
    const glint::Result<glint::World> world = glint::prepare(*scene);
    const glint::Result<glint::Explanation> pixel = glint::explain(*scene, *world, 1, 1);
    expect(pixel && pixel->rays[0].hit && pixel->rays[0].hit->n_v == 0.8, "recorded");
    if (!pixel) return 1;
    const glint::Result<std::string> json = glint::explanation_json(*pixel, *scene);
    expect(json && json->find("\"n_v\":0.8,") != std::string::npos, "in JSON");
    int listed = 0;
    glint::for_listed_terms(
        glint::k_hit_terms, *pixel->rays[0].hit,
        [&](std::string_view label, double value) { listed += label == "N·V" && value == 0.8 ? 1 : 0; });
    expect(listed == 1, "in texts");
    std::printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}
