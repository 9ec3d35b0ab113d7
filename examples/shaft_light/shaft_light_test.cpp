// SPDX-License-Identifier: Apache-2.0
// Renders with the light that was added, and compares which points are lit with the distance from its axis.
#include <cmath>
#include <cstdio>

#include "glint/glint.h"

namespace {

int failures = 0;
void expect(bool good, const char* what, int x = 0, int y = 0) {
    if (good) return;
    if (++failures < 10) std::printf("(%d, %d): %s\n", x, y, what);
}

// The plane y = 0, seen from above by parallel rays: x to the right, z downwards.
constexpr int k_size = 101;
constexpr double k_width = 6;
glint::Scene floor_under(const glint::Light& light) {
    glint::Scene scene;
    scene.settings.width = scene.settings.height = k_size;
    scene.settings.shading = glint::Shading::diffuse;
    scene.camera.projection = glint::Projection::orthographic;
    scene.camera.position = {0, 9, 0};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.up = {0, 0, -1};
    scene.camera.width = k_width;
    scene.lights = {light};
    glint::Material white;
    white.diffuse = {1, 1, 1};
    scene.materials = {white};
    scene.add(glint::Plane{}, 0);
    return scene;
}

glint::Light slanting_shaft() {
    glint::Light light;
    light.kind = glint::LightKind::shaft;
    light.to_light = {3, 4, 0};
    light.center = {0.5, 0, 0.25};
    light.shaft_radius = 1.5;
    return light;
}

void check_picture() {
    const glint::Light light = slanting_shaft();
    const glint::Result<glint::World> prepared = glint::prepare(floor_under(light));
    if (!prepared) return expect(false, "no world");
    for (const std::string& isa : glint::isa_names()) {
        glint::RenderOptions options;
        options.isa = isa;
        const glint::Result<glint::Rendering> result = glint::render(*prepared, options);
        if (!result) return expect(false, "no picture");
        for (int y = 0; y < k_size; ++y) {
            for (int x = 0; x < k_size; ++x) {
                const glint::Vec3 p{(x + 0.5 - k_size * 0.5) * k_width / k_size, 0,
                                    (y + 0.5 - k_size * 0.5) * k_width / k_size};
                const glint::Vec3 from_axis = cross(p - light.center, light.to_light / 5);
                const double distance = std::sqrt(dot(from_axis, from_axis));
                if (std::fabs(distance - light.shaft_radius) < 1e-6) continue;
                const float lit = result->image.rgb[3 * static_cast<std::size_t>(y * k_size + x)];
                expect(std::fabs(lit - (distance < light.shaft_radius ? 0.8 : 0)) < 1e-6, "the light", x, y);
            }
        }
    }
}

void check_explanation() {
    const glint::Scene scene = floor_under(slanting_shaft());
    const glint::Result<glint::World> prepared = glint::prepare(scene);
    if (!prepared) return expect(false, "no world");
    const glint::Explanation corner = glint::explain(scene, *prepared, 0, 0).value();
    expect(corner.rays.size() == 1 && corner.rays[0].hit && corner.rays[0].hit->lights.size() == 1 &&
               glint::reason(corner.rays[0].hit->lights[0]) == glint::LightReason::faded,
           "why it is dark outside");
}

glint::Result<glint::Scene> load(const std::string& light) {
    const std::string scene =
        "camera { position = (0, 0, 5) }\nsphere { center = (0, 0, 0)  radius = 1 }\n" + light;
    const glint::SceneText text{"shaft.glint", scene, ""};
    return glint::load({&text, 1});
}

void check_language() {
    const glint::Result<glint::Scene> loaded =
        load("light { type = shaft  to_light = (0, 1, 0)  center = (1, 2, 3)  shaft_radius = 0.25 }\n");
    if (!loaded) return expect(false, glint::to_string(loaded.diagnostics.at(0)).c_str());
    const std::string written = glint::write_glint(*loaded).value();
    const glint::SceneText again{"again.glint", written, ""};
    const glint::Result<glint::Scene> reloaded = glint::load({&again, 1});
    if (!reloaded) return expect(false, "written and read again");
    const glint::Light& light = reloaded->lights.at(0);
    expect(light.kind == glint::LightKind::shaft && light.center == glint::Vec3{1, 2, 3} &&
               light.shaft_radius == 0.25,
           "the same light");
    const auto says = [](const glint::Result<glint::Scene>& result, const char* message) {
        return !result.diagnostics.empty() && result.diagnostics[0].message == message;
    };
    expect(says(load("light { type = shaft  to_light = (0, 1, 0) }"), "expected `center` in the shaft light"),
           "a shaft without a center");
    expect(says(load("light { position = (0, 9, 0)  shaft_radius = 2 }"),
                "glint ignores the 'shaft_radius' of a point light"),
           "a radius of a point light");
    expect(says(load("light { type = shaft  to_light = (0, 1, 0)  center = (0, 0, 0)  shaft_radius = 0 }"),
                "expected a number > 0 and at most 1e12, found '0'"),
           "a radius of 0");
    glint::Light broken = slanting_shaft();
    broken.shaft_radius = -1;
    expect(glint::has_errors(glint::validate(floor_under(broken))), "a negative radius in code");
}

}  // namespace

int main() {
    check_picture();
    check_explanation();
    check_language();
    std::printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}
