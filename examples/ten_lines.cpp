// SPDX-License-Identifier: Apache-2.0
// A scene made in code, and its picture in ten_lines.png.
#include <glint/glint.h>

#include <fstream>

int main() {
    glint::Scene scene;
    scene.materials.push_back({.diffuse = {0.8, 0.1, 0.1}, .specular = {0.5, 0.5, 0.5}, .mirror = 0.2});
    scene.add(glint::Sphere{.center = {0, 0, -4}, .radius = 1}, 0);
    scene.add(glint::Plane{.point = {0, -1, 0}});
    scene.lights.push_back({.position = {4, 5, 0}});
    const auto prepared = glint::prepare(scene);
    if (!prepared) return 1;  // to_string(prepared) says why
    const auto png = glint::encode(glint::render(*prepared).value().image).value();
    std::ofstream file("ten_lines.png", std::ios::binary);
    file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
}
