// SPDX-License-Identifier: Apache-2.0
// A light that moves: the scene is prepared once, and each picture takes only the time of rendering. Writes
// move_light_0.png, move_light_1.png, ... Run: move_light [PICTURES [LIGHTS]].
#include <glint/glint.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
    const int pictures = argc > 1 ? std::atoi(argv[1]) : 3, moves = argc > 2 ? std::atoi(argv[2]) : 1000;
    glint::Scene scene;
    scene.settings.width = scene.settings.height = 200;
    scene.camera.position = {0, 4, 12};
    scene.materials.push_back({.diffuse = {0.8, 0.3, 0.1}, .specular = {0.5, 0.5, 0.5}});
    for (int i = 0; i < 1000; ++i)
        scene.add(glint::Sphere{.center = {i % 10 - 4.5, i / 10 % 10 - 4.5, -(i / 100.0)}, .radius = 0.4}, 0);
    scene.lights.push_back({.position = {-9, 9, 9}});
    const auto prepared = glint::prepare(scene);
    if (!prepared) return 1;

    // The changed World shares the shapes with the original, which is not changed.
    glint::World world = *prepared;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < moves; ++i) {
        scene.lights[0].position.x = -9 + 18.0 * i / moves;
        const auto moved = glint::with_lights(world, scene.lights);
        if (!moved) return 1;  // moved.message says why
        world = *moved;
    }
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    std::cout << moves << " moves of a light: " << time.count() / moves << " microseconds each\n";

    for (int i = 0; i < pictures; ++i) {
        scene.lights[0].position.x = -9 + 18.0 * i / pictures;
        const auto moved = glint::with_lights(world, scene.lights);
        const auto png = glint::encode(glint::render(moved.value()).value().image).value();
        std::ofstream file("move_light_" + std::to_string(i) + ".png", std::ios::binary);
        file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    }
}
