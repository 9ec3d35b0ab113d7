// SPDX-License-Identifier: Apache-2.0
// Scenes of many shapes take no longer than their size explains.
#include <chrono>

#include "check/check_text.h"

namespace glint::test {
namespace {

double seconds_of_check(const Scene& scene) {
    const auto start = std::chrono::steady_clock::now();
    check_loaded(scene);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// n spheres on a floor; every tenth stands in the place of the one before it.
Scene field(int n) {
    Scene scene;
    scene.camera.position = {0, 30, 60};
    scene.camera.look_at = {0, 0, 0};
    Light light;
    light.position = {20, 80, 40};
    scene.lights.push_back(light);
    scene.add(Plane{{0, -1, 0}, {0, 1, 0}});
    const double side = std::sqrt(n);
    for (int i = 0; i < n; ++i) {
        const int place = i % 10 == 9 ? i - 1 : i;
        scene.add(
            Sphere{{(place % int(side) / side - 0.5) * 80, 0, (place / side / side - 0.5) * 80}, 20 / side});
    }
    return scene;
}

TEST(CheckScale, IsNotQuadratic) {
    const double small = seconds_of_check(field(4000)), large = seconds_of_check(field(64000));
    // 16 times the shapes; a quadratic check would take 256 times as long.
    EXPECT_LT(large, 48 * small + 1) << small << " s and " << large << " s";
}

TEST(CheckScale, ThousandsInOnePlane) {
    // Each of the flat triangles lies in the plane of all others, and in that of the floor.
    Scene scene = field(10);
    for (int i = 0; i < 50000; ++i) {
        const double x = i % 250 * 0.2 - 25, z = i / 250 * 0.2 - 20;
        scene.add(Triangle{{{x, -1, z}, {x, -1, z + 0.15}, {x + 0.15, -1, z}}});
    }
    scene.materials.push_back({});
    scene.materials[0].diffuse = {0.1, 0.2, 0.1};
    for (std::size_t i = 11; i < scene.shapes.size(); ++i) scene.shapes[i].material = 0;
    const std::vector<Finding> result = check_loaded(scene);
    EXPECT_TRUE(has(ids(result), "faces-coincide")) << ids(result);
    EXPECT_LE(result.size(), 12u) << ids(result);
}

}  // namespace
}  // namespace glint::test
