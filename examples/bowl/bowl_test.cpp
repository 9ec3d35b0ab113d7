// SPDX-License-Identifier: Apache-2.0
// Renders the bowl, and compares its normals and its outline with those of the definition.
#include <cmath>
#include <cstdio>

#include "glint/glint.h"

namespace {

int failures = 0;
void expect(bool good, const char* what, int x, int y) {
    if (good) return;
    if (++failures < 10) std::printf("(%d, %d): %s\n", x, y, what);
}

// Seen from the end of the z axis by parallel rays, with its opening turned to them: the picture is a disc.
void check_disc() {
    constexpr int size = 401;
    constexpr double radius = 1.2, height = 0.7, width = 3;
    glint::Scene scene;
    scene.settings.width = scene.settings.height = size;
    scene.settings.shading = glint::Shading::normals;
    scene.camera.projection = glint::Projection::orthographic;
    scene.camera.position = {0, 0, 9};
    scene.camera.width = width;
    glint::Affine upright;  // y becomes z
    upright.m[1][1] = 0, upright.m[1][2] = -1;
    upright.m[2][1] = 1, upright.m[2][2] = 0;
    scene.transforms = {upright};
    scene.add(glint::Bowl{radius, height}, glint::k_none, 0);
    const auto prepared = glint::prepare(scene);
    if (!prepared) return expect(false, "no world", 0, 0);
    for (const std::string& isa : glint::isa_names()) {
        glint::RenderOptions options;
        options.isa = isa;
        const auto result = glint::render(*prepared, options);
        if (!result) return expect(false, result.message.c_str(), 0, 0);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const double px = (x + 0.5 - size * 0.5) * width / size,
                             py = (size * 0.5 - y - 0.5) * width / size;
                const double rho = std::sqrt(px * px + py * py);
                const float* rgb = &result->image.rgb[3 * static_cast<std::size_t>(y * size + x)];
                if (std::fabs(rho - radius) < 1e-9) continue;
                if (rho > radius) {
                    expect(rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 1, "the background", x, y);
                    continue;
                }
                // Seen from above, the normal of an open shape is turned up.
                const double slope = 2 * height / (radius * radius);
                const double across = std::sqrt(1 + slope * slope * rho * rho);
                const double nx = -slope * px / across, ny = -slope * py / across, nz = 1 / across;
                expect(std::fabs(rgb[0] - (nx + 1) / 2) < 1e-6 && std::fabs(rgb[1] - (ny + 1) / 2) < 1e-6 &&
                           std::fabs(rgb[2] - (nz + 1) / 2) < 1e-6,
                       "the normal", x, y);
            }
        }
    }
}

void check_language() {
    const glint::SceneText text{
        "bowl.glint",
        "camera { position = (0, 0, 5)  look_at = (0, 0, 0)  up = (0, 1, 0)  fov_x = 40 }\n"
        "light { position = (1, 2, 3) }\n"
        "bowl \"bowl\" { radius = 2  height = 0.5  rotate = (90, 0, 0) }\n",
        ""};
    const glint::Result<glint::Scene> loaded = glint::load({&text, 1});
    if (!loaded) return expect(false, glint::to_string(loaded.diagnostics.at(0)).c_str(), 0, 0);
    const auto& bowls = loaded->get<glint::Bowl>();
    expect(bowls.size() == 1 && bowls[0].radius == 2 && bowls[0].height == 0.5, "read from .glint", 0, 0);
    const std::string written = glint::write_glint(*loaded).value();
    const glint::SceneText again{"again.glint", written, ""};
    const glint::Result<glint::Scene> reloaded = glint::load({&again, 1});
    expect(reloaded && reloaded->get<glint::Bowl>().size() == 1, "written and read again", 0, 0);
}

void check_validation() {
    glint::Scene scene;
    scene.add(glint::Bowl{1, -1});
    expect(glint::has_errors(glint::validate(scene)), "a negative height is refused", 0, 0);
}

}  // namespace

int main() {
    check_disc();
    check_language();
    check_validation();
    std::printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}
