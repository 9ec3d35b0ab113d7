// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shared by the tests of misuse.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <utility>

#include "glint/glint.h"

namespace glint::test {

inline constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double k_infinity = std::numeric_limits<double>::infinity();
inline constexpr double k_odd_numbers[] = {k_nan, k_infinity, -k_infinity, 1e300, -1e300};
inline constexpr std::int32_t k_odd_sizes[] = {0, -1, std::numeric_limits<std::int32_t>::min(),
                                               std::numeric_limits<std::int32_t>::max()};

/// A value outside every enumeration.
template <class Enum> constexpr Enum beyond() { return static_cast<Enum>(200); }

/// A mirror, a glass ball and a triangle on a plane, under one light of each kind.
inline Scene some_scene() {
    Scene scene;
    scene.settings.width = 16;
    scene.settings.height = 12;
    scene.camera.position = {0, 1, 6};
    scene.camera.look_at = {0, 0.5, 0};
    scene.lights = {{.kind = LightKind::ambient},
                    {.position = {3, 5, 4}},
                    {.kind = LightKind::directional},
                    {.kind = LightKind::spot, .position = {0, 6, 0}},
                    {.kind = LightKind::parallelogram, .position = {0, 7, 0}},
                    {.kind = LightKind::disc, .position = {1, 7, 0}, .jitter = true}};
    scene.materials = {{.specular = {0.5, 0.5, 0.5}, .mirror = 0.5}, {.transmission = 0.8, .ior = 1.5}};
    scene.transforms = {Affine{}};
    scene.add(Plane{.point = {0, -1, 0}}, 0);
    scene.add(Sphere{.center = {-1, 0, 0}, .radius = 1}, 0);
    scene.add(Sphere{.center = {1, 0, 1}, .radius = 1}, 1, 0);
    scene.add(Triangle{{{-3, -1, -3}, {3, -1, -3}, {0, 3, -3}}});
    return scene;
}

inline World world_of(const Scene& scene) {
    Result<World> prepared = prepare(scene);
    EXPECT_TRUE(prepared) << prepared.message;
    return prepared.value_or(World{});
}

inline Image picture(std::int32_t width, std::int32_t height, float value = 0.5f) {
    return {width, height, std::vector<float>(std::size_t{3} * width * height, value)};
}

/// Pictures whose number of values does not fit their size.
inline std::vector<Image> misfits() {
    std::vector<Image> images;
    for (const std::int32_t size : k_odd_sizes) {
        images.push_back({size, 4, std::vector<float>(12)});
        images.push_back({4, size, std::vector<float>(12)});
        images.push_back({size, size, {}});
    }
    images.push_back({2, 2, std::vector<float>(11)});
    images.push_back({2, 2, std::vector<float>(13)});
    images.push_back({2, 2, {}});
    Image moved = picture(2, 2);
    const Image elsewhere = std::move(moved);
    images.push_back(moved);  // NOLINT(bugprone-use-after-move): that is what is tested
    return images;
}

}  // namespace glint::test
