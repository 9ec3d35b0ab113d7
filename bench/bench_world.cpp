// SPDX-License-Identifier: Apache-2.0
// The cost of changes to a World: medians, for a scene of a million spheres with a thousand materials.
// Run: bench_world [SHAPES [THREADS]].
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "glint/glint.h"

namespace {

using Clock = std::chrono::steady_clock;

glint::Scene make_scene(std::uint32_t shapes) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(-1, 1);
    glint::Scene scene;
    scene.camera.position = {0, 0, 4};
    scene.lights.resize(3);
    scene.materials.resize(1000);
    for (std::uint32_t i = 0; i < shapes; ++i)
        scene.add(glint::Sphere{{in(random), in(random), in(random)}, 0.005}, i % 1000);
    return scene;
}

// One row: the median of `times` calls, after a warm-up call.
void measure(const char* what, int times, const std::function<void(int)>& call) {
    call(-1);
    std::vector<double> seconds;
    for (int i = 0; i < times; ++i) {
        const auto start = Clock::now();
        call(i);
        seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + times / 2, seconds.end());
    const auto median = seconds[static_cast<std::size_t>(times) / 2];
    fmt::print("{:<44} {:>8} {:>12.1f}\n", what, times, median * 1e6);
}

[[noreturn]] void fail(const char* what) {
    fmt::print("{} has failed\n", what);
    std::exit(1);
}

glint::World made(glint::Result<glint::World> result, const char* what) {
    if (!result) fail(what);
    return *std::move(result);
}

}  // namespace

int main(int argc, char** argv) {
    const auto count = static_cast<std::uint32_t>(argc > 1 ? std::atol(argv[1]) : 1000000);
    const glint::PrepareOptions options{.threads = argc > 2 ? std::atoi(argv[2]) : 2};
    glint::Scene scene = make_scene(count);
    glint::World world;
    fmt::print("{} shapes, {} threads\n{:<44} {:>8} {:>12}\n", count, options.threads, "", "times",
               "median (us)");
    measure("prepare()", 5, [&](int) { world = made(glint::prepare(scene, options), "prepare()"); });
    measure("with_lights(), 3 lights", 1000, [&](int i) {
        scene.lights[0].position.x = i;
        world = made(glint::with_lights(world, scene.lights), "with_lights()");
    });
    measure("with_camera()", 1000, [&](int i) {
        scene.camera.position.x = i * 1e-3;
        world = made(glint::with_camera(world, scene.camera), "with_camera()");
    });
    measure("with_background()", 1000, [&](int i) {
        world = made(glint::with_background(world, {i * 1e-3, 0, 0}), "with_background()");
    });
    measure("with_rules()", 1000, [&](int i) {
        scene.conventions.epsilon = (i + 2) * 1e-12;
        world = made(glint::with_rules(world, scene.conventions, scene.settings), "with_rules()");
    });
    measure("with_material(), of 1000", 1000, [&](int i) {
        scene.materials[5].shininess = i + 2;
        world = made(glint::with_material(world, 5, scene.materials[5]), "with_material()");
    });
    measure("with_materials(), 1000", 1000, [&](int i) {
        scene.materials[5].shininess = i + 2;
        world = made(glint::with_materials(world, scene.materials), "with_materials()");
    });
    const auto edit = [&](glint::World& edited, const std::vector<std::uint32_t>& changed) {
        const auto result = glint::edit_shapes(edited, scene, changed, options);
        if (!result || *result != glint::ShapeEdit::refitted) fail("edit_shapes()");
    };
    std::vector<std::uint32_t> one(1), many(1000), all(count);
    std::iota(all.begin(), all.end(), 0u);
    const auto move = [&](std::uint32_t shape, int i) {
        scene.get<glint::Sphere>()[shape].center.x += i % 2 == 0 ? 1e-3 : -1e-3;
    };
    const auto start = Clock::now();
    edit(world, one);
    fmt::print("{:<44} {:>8} {:>12.1f}\n", "edit_shapes(), the first time", 1,
               std::chrono::duration<double>(Clock::now() - start).count() * 1e6);
    measure("assign_material(), 1 shape", 1000, [&](int i) {
        one[0] = static_cast<std::uint32_t>(i + 1) * 997 % count;
        if (!glint::assign_material(world, one, 3)) fail("assign_material()");
    });
    measure("edit_shapes(), 1 shape", 1000, [&](int i) {
        one[0] = static_cast<std::uint32_t>(i + 1) * 997 % count;
        move(one[0], i);
        edit(world, one);
    });
    measure("edit_shapes(), 1000 shapes", 100, [&](int i) {
        for (std::uint32_t k = 0; k < many.size(); ++k) many[k] = k * 991 % count, move(many[k], i);
        edit(world, many);
    });
    measure("edit_shapes(), all shapes", 21, [&](int i) {
        for (const std::uint32_t shape : all) move(shape, i);
        const auto begin = Clock::now();
        edit(world, all);
        if (i == 0)
            fmt::print("{:>66.1f} without moving them\n",
                       std::chrono::duration<double>(Clock::now() - begin).count() * 1e6);
    });
    measure("edit_shapes(), 1 shape, a copy exists", 21, [&](int i) {
        const glint::World copy = world;
        move(one[0], i);
        edit(world, one);
    });
    measure("splice_shapes(), 1 shape put in", 21, [&](int) {
        one[0] = scene.add(glint::Sphere{{0.1, 0.2, 0.3}, 0.001});
        if (!glint::splice_shapes(world, scene, {}, one, options)) fail("splice_shapes()");
    });
    measure("splice_shapes(), 1 shape taken out", 21, [&](int) {
        one[0] = count / 2;
        scene.shapes.erase(scene.shapes.begin() + one[0]);
        if (!glint::splice_shapes(world, scene, one, {}, options)) fail("splice_shapes()");
    });
    one[0] = 1;
    // Each edit is of another copy of a World that is never edited itself.
    scene = make_scene(count);
    const glint::World base = made(glint::prepare(scene, options), "prepare()");
    measure("edit_shapes(), 1 shape of a new copy", 21, [&](int i) {
        glint::World copy = base;
        move(one[0], i);
        edit(copy, one);
    });
}
