// SPDX-License-Identifier: Apache-2.0
// Rays that leave the surfaces of meshes, under maps of all sizes: no surface shadows itself, and no light
// passes between two triangles.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/transform.h"
#include "trace/pictures.h"
#include "trace/worlds.h"

namespace glint::test {
namespace {

constexpr int k_rings = 24, k_segments = 48;

struct Named {
    const char* name;
    Affine map;
};

std::vector<Named> maps() {
    const Affine turned = compose(rotation_y(31), rotation_x(17));
    return {{"none", Affine{}},
            {"small", scaling({1e-6, 1e-6, 1e-6})},
            {"large", scaling({1e6, 1e6, 1e6})},
            {"mirrored", scaling({-1, 1, 1})},
            {"uneven", compose(turned, scaling({30, 1, 0.03}))},
            {"uneven by 1e9", compose(turned, scaling({1, 1, 1e-9}))},
            {"far", translation({-1e6, 3e5, 0})},
            {"far and turned",
             compose(turned, compose(scaling({1e-3, 1e-3, -1e-3}), translation({1e8, 0, 5e7})))}};
}

// A ball of radius 1 around the origin of the world: the mesh's coordinates are those before the map.
MeshData ball(const Affine& map) {
    const Affine to_object = inverse(map).value();
    MeshData mesh;
    for (int ring = 0; ring <= k_rings; ++ring) {
        for (int segment = 0; segment < k_segments; ++segment) {
            const double polar = std::numbers::pi * ring / k_rings,
                         around = 2 * std::numbers::pi * segment / k_segments;
            mesh.positions.push_back(transform_point(
                to_object,
                {std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)}));
        }
    }
    for (std::uint32_t ring = 0; ring < k_rings; ++ring) {
        for (std::uint32_t segment = 0; segment < k_segments; ++segment) {
            const std::uint32_t next = (segment + 1) % k_segments, a = ring * k_segments + segment,
                                b = ring * k_segments + next, c = a + k_segments, d = b + k_segments;
            if (ring > 0) mesh.triangles.push_back({a, b, c});
            if (ring + 1 < k_rings) mesh.triangles.push_back({b, d, c});
        }
    }
    return mesh;
}

Scene scene_of(const Affine& map, Vec3 eye, double fov) {
    Scene scene;
    set_size(scene, 90, 70);
    scene.camera.position = eye;
    scene.camera.look_at = {0, 0, 0};
    scene.camera.fov_degrees = fov;
    scene.meshes.push_back(std::make_shared<const MeshData>(ball(map)));
    scene.transforms.push_back(map);
    Material white;
    white.color = {1, 1, 1};
    scene.materials.push_back(white);
    scene.add(Mesh{0}, 0, 0);
    scene.conventions.facing = Facing::all;
    return scene;
}

TEST(MeshRays, ABallIsNotInItsOwnShadow) {
    for (const auto& [name, map] : maps()) {
        for (const double distance : {3.0, 1e5}) {
            Scene scene = scene_of(map, {0, 0.3 * distance, distance}, distance > 10 ? 0.0012 : 50);
            scene.lights = {point_light({4, 5, 6})};
            const Image shadows = render_scene(scene);
            scene.settings.shadows = false;
            const Image none = render_scene(scene);
            std::size_t lit = 0, other = 0;
            for (std::size_t i = 0; i < none.rgb.size(); ++i)
                lit += none.rgb[i] > 0, other += none.rgb[i] != shadows.rgb[i];
            EXPECT_GT(lit, none.rgb.size() / 10) << name;
            EXPECT_EQ(other, 0u) << name << ", from " << distance;
        }
    }
}

TEST(MeshRays, NoLightEntersAClosedBall) {
    for (const auto& [name, map] : maps()) {
        Scene scene = scene_of(map, {0, 0, 0.1}, 120);
        scene.lights = {point_light({0, 0, -3}), point_light({4, 5, -6}), point_light({1e5, 3, -8e5})};
        const Image dark = render_scene(scene);
        std::size_t lit = 0;
        for (const float channel : dark.rgb) lit += channel != 0;
        EXPECT_EQ(lit, 0u) << name;
        scene.settings.shadows = false;
        EXPECT_NE(render_scene(scene).rgb, dark.rgb) << name;
    }
}

}  // namespace
}  // namespace glint::test
