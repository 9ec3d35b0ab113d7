// SPDX-License-Identifier: Apache-2.0
// contains() agrees with what is inside of shapes by definition.
#include "world/geometry/contains.h"

#include <gtest/gtest.h>

#include "trace/random_solid.h"
#include "trace/worlds.h"
#include "world/world.h"

namespace glint::test {
namespace {

// The slot of the world's only shape: operands come last.
bool contains(const World& world, Vec3 point) { return glint::contains(*world.parts().geometry, 0, point); }

TEST(Contains, RandomShapesAndSolids) {
    Random random(41);
    int inside = 0, points = 0;
    for (int i = 0; i < 300; ++i) {
        Scene scene;
        const Part part = random_solid(scene, random, 1 + i % 6);
        scene.shapes.push_back(part.shape);
        const bool is_moved = i % 3 == 0;
        const Vec3 move{random.uniform(-3, 3), 1, 2}, size{random.uniform(0.5, 2), 1.5, -1};
        if (is_moved) {
            Affine map;
            for (int a = 0; a < 3; ++a) map.m[a][a] = a == 0 ? size.x : a == 1 ? size.y : size.z;
            map.m[0][3] = move.x, map.m[1][3] = move.y, map.m[2][3] = move.z;
            scene.transforms.push_back(map);
            scene.shapes.back().transform = static_cast<std::uint32_t>(scene.transforms.size() - 1);
        }
        const World world = *make_world(scene);
        for (int k = 0; k < 200; ++k) {
            const Vec3 point = point_in_cube(random, 2);
            const Vec3 moved = Vec3{point.x * size.x, point.y * size.y, point.z * size.z} + move;
            const bool expected = part.inside(point);
            inside += expected ? 1 : 0;
            points += contains(world, is_moved ? moved : point) == expected ? 1 : 0;
        }
    }
    EXPECT_EQ(points, 300 * 200);
    EXPECT_GT(inside, 5000);
}

TEST(Contains, ATorusThatIntersectsItself) {
    Scene scene;
    scene.add(Torus{{0, 0, 0}, {0, 1, 0}, 1, 1.5});
    const World world = *make_world(scene);
    EXPECT_TRUE(contains(world, {1, 0, 0}));
    EXPECT_TRUE(contains(world, {0, 1.2, 0.3}));
    EXPECT_FALSE(contains(world, {0, 0, 0}));  // enclosed twice
    EXPECT_FALSE(contains(world, {3, 0, 0}));
}

TEST(Contains, NothingInOpenShapes) {
    Scene scene;
    scene.add(Cylinder{{0, 0, 0}, {0, 1, 0}, 1, false});
    EXPECT_FALSE(contains(*make_world(scene), {0, 0.5, 0}));
}

}  // namespace
}  // namespace glint::test
