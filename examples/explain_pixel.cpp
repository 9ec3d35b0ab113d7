// SPDX-License-Identifier: Apache-2.0
// Why a pixel has its color: the rays that were traced for it, and each light at each hit. Run:
// explain_pixel [X Y], of a picture of 320x240.
#include <glint/glint.h>

#include <cstdlib>
#include <iostream>

namespace {

std::ostream& operator<<(std::ostream& out, glint::Color c) {
    return out << '(' << c.r << ", " << c.g << ", " << c.b << ')';
}

// A mirror ball and a red ball on a floor, under one light.
glint::Scene make_scene() {
    glint::Scene scene;
    scene.settings.width = 320, scene.settings.height = 240;
    scene.camera.position = {0, 1, 6};
    scene.materials.push_back({.diffuse = {0.2, 0.2, 0.2}, .mirror = 0.7});
    scene.materials.push_back({.diffuse = {0.8, 0.1, 0.1}, .specular = {0.5, 0.5, 0.5}});
    scene.add(glint::Sphere{.center = {-1, 0, 0}}, 0);
    scene.add(glint::Sphere{.center = {1.2, 0, 0.5}}, 1);
    scene.add(glint::Plane{.point = {0, -1, 0}});
    scene.lights.push_back({.position = {4, 5, 3}});
    return scene;
}

int fail(const glint::Status& status) { return std::cerr << to_string(status), 1; }

}  // namespace

int main(int argc, char** argv) {
    const int x = argc > 2 ? std::atoi(argv[1]) : 125, y = argc > 2 ? std::atoi(argv[2]) : 130;
    const glint::Scene scene = make_scene();
    const auto world = glint::prepare(scene);
    if (!world) return fail(world);
    const auto explained = glint::explain(scene, *world, x, y);
    if (!explained) return fail(explained);

    for (const glint::ExplainedRay& ray : explained->rays) {
        const char* kind = ray.parent < 0 ? "camera" : ray.transmitted ? "transmitted" : "mirror";
        std::cout << kind << " ray, weight " << ray.weight << ": ";
        if (!ray.hit) {
            std::cout << "meets nothing, adds " << ray.background << '\n';
            continue;
        }
        std::cout << "hits " << to_string(scene.shapes[ray.hit->shape].kind) << ' ' << ray.hit->shape
                  << " at t = " << ray.t << '\n';
        for (const glint::LightTerms& terms : ray.hit->lights) {
            std::cout << "  light " << terms.light << ": " << to_string(glint::reason(terms)) << ", N.L "
                      << terms.n_l << ", diffuse " << terms.diffuse << ", specular " << terms.specular
                      << '\n';
        }
    }
    const float* v = explained->value;
    std::cout << "pixel " << x << ',' << y << ": " << glint::Color{v[0], v[1], v[2]} << '\n';
}
