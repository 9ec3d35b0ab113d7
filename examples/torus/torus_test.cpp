// SPDX-License-Identifier: Apache-2.0
// Renders the torus, and compares its normals and its outline with those of the definition.
#include <cmath>
#include <cstdio>

#include "glint/glint.h"

namespace {

int failures = 0;
void expect(bool good, const char* what, int x, int y) {
    if (good) return;
    if (++failures < 10) std::printf("(%d, %d): %s\n", x, y, what);
}

// Seen from the end of the z axis by parallel rays, with the hole along y turned to z: the picture is a ring.
void check_ring() {
    constexpr int size = 401;
    constexpr double radius = 1, tube = 0.3, width = 3;
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
    scene.add(glint::Torus{radius, tube}, glint::k_none, 0);
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
                const double rho = std::sqrt(px * px + py * py), across = rho - radius;
                const float* rgb = &result->image.rgb[3 * static_cast<std::size_t>(y * size + x)];
                const bool on = std::fabs(across) < tube;
                if (std::fabs(std::fabs(across) - tube) < 1e-9) continue;
                if (!on) {
                    expect(rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 1, "the background", x, y);
                    continue;
                }
                const double nx = px / rho * across / tube, ny = py / rho * across / tube,
                             nz = std::sqrt(1 - across * across / (tube * tube));
                expect(std::fabs(rgb[0] - (nx + 1) / 2) < 1e-6 && std::fabs(rgb[1] - (ny + 1) / 2) < 1e-6 &&
                           std::fabs(rgb[2] - (nz + 1) / 2) < 1e-6,
                       "the normal", x, y);
            }
        }
    }
}

void check_language() {
    const glint::SceneText text{
        "ring.glint",
        "camera { position = (0, 0, 5)  look_at = (0, 0, 0)  up = (0, 1, 0)  fov_x = 40 }\n"
        "light { position = (1, 2, 3) }\n"
        "torus \"ring\" { radius = 2  tube = 0.5  rotate = (90, 0, 0) }\n",
        ""};
    const glint::Result<glint::Scene> loaded = glint::load({&text, 1});
    if (!loaded) return expect(false, glint::to_string(loaded.diagnostics.at(0)).c_str(), 0, 0);
    const auto& tori = loaded->get<glint::Torus>();
    expect(tori.size() == 1 && tori[0].radius == 2 && tori[0].tube == 0.5, "read from .glint", 0, 0);
    const std::string written = glint::write_glint(*loaded).value();
    const glint::SceneText again{"again.glint", written, ""};
    const glint::Result<glint::Scene> reloaded = glint::load({&again, 1});
    expect(reloaded && reloaded->get<glint::Torus>().size() == 1, "written and read again", 0, 0);
}

void check_validation() {
    glint::Scene scene;
    scene.add(glint::Torus{1, -1});
    expect(glint::has_errors(glint::validate(scene)), "a negative tube is refused", 0, 0);
}

// A light inside the tube, in a torus that the check's ray leaves, enters again and leaves: no convex shape.
void check_inside() {
    const auto unit = [](glint::Vec3 v) { return v * (1 / std::sqrt(glint::dot(v, v))); };
    const glint::Vec3 along = unit({0.5773, 0.6211, 0.5301}), axis = unit(glint::cross(along, {0, 0, 1})),
                      across = glint::cross(along, axis);
    glint::Affine turned;  // x becomes along, y becomes axis
    const glint::Vec3 columns[3] = {along, axis, across};
    for (int c = 0; c < 3; ++c) {
        turned.m[0][c] = columns[c].x;
        turned.m[1][c] = columns[c].y;
        turned.m[2][c] = columns[c].z;
    }
    glint::Scene scene;
    scene.settings.width = scene.settings.height = 80;
    scene.camera.position = axis * 6;
    scene.transforms = {turned};
    scene.add(glint::Torus{1, 0.3}, glint::k_none, 0);
    const auto finds = [&](glint::Vec3 light) {
        scene.lights = {{.position = light}};
        for (const glint::Finding& finding : glint::check(scene).value()) {
            if (finding.id == "light-inside-shape") return true;
        }
        return false;
    };
    expect(finds(along * -1), "the light is in the tube", 0, 0);
    expect(!finds({0, 0, 0}), "the light is in the hole", 0, 0);
}

}  // namespace

int main() {
    check_ring();
    check_language();
    check_validation();
    check_inside();
    std::printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}
