// SPDX-License-Identifier: Apache-2.0
// nearest_hits() and occluded() return the kernels' results with the scene's indices.
#include "trace/hit_rule.h"
#include "trace/worlds.h"

namespace glint::test {
namespace {

TEST(RayQueries, FollowTheHitRule) {
    Random random(301);
    const Scene scene = random_scene(random, 300);
    const World world = *make_world(scene);
    std::vector<Ray> rays;
    Rays columns;
    for (int i = 0; i < 1111; ++i) {
        Ray ray{point_in_cube(random, 15), unit_direction(random) * log_uniform(random, 0.1, 10)};
        if (chance(random, 0.3))
            ray.t_min = random.uniform(0, 3), ray.t_max = ray.t_min + random.uniform(0, 3);
        rays.push_back(ray);
        columns.push(ray.origin, ray.direction, ray.t_min, ray.t_max);
    }
    const Hits expected = brute_hits(world, columns);
    for (const int threads : {1, 3}) {
        const std::vector<RayHit> found = nearest_hits(world, rays, threads).value();
        const std::vector<std::uint8_t> any = occluded(world, rays, threads).value();
        ASSERT_EQ(found.size(), rays.size());
        ASSERT_EQ(any.size(), rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::uint32_t slot = expected.slot[i];
            EXPECT_EQ(found[i].t, expected.t[i]);
            EXPECT_EQ(found[i].shape, slot == k_none ? k_none : world.parts().geometry->shape_index[slot]);
            EXPECT_EQ(any[i], slot == k_none ? 0 : 1);
        }
    }
}

TEST(RayQueries, ReturnTheShapesOwnNormal) {
    Scene scene;
    scene.transforms.push_back(translation({0, 0, -10}));
    scene.add(Sphere{{0, 0, 0}, 2});
    scene.add(Sphere{{0, 0, 0}, 1}, k_none, 0);
    scene.conventions.facing = Facing::all;
    const World world = *make_world(scene);
    const Ray rays[] = {{{0, 0, 5}, {0, 0, -2}},
                        {{0, 0, 0}, {0, 0, 1}},
                        {{0, 0, -5}, {0, 0, -1}},
                        {{0, 9, 5}, {0, 0, -2}, 0, 7},
                        {{0, NAN, 5}, {0, 0, -2}}};
    const std::vector<RayHit> found = nearest_hits(world, rays).value();
    EXPECT_EQ(found[0].t, 1.5);
    EXPECT_EQ(found[0].normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(found[1].normal, (Vec3{0, 0, 1})) << "from inside";
    EXPECT_EQ(found[2].shape, 1u);
    EXPECT_EQ(found[2].normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(found[3].shape, k_none);
    EXPECT_EQ(found[3].t, 7);
    EXPECT_EQ(found[4].shape, k_none);
    EXPECT_TRUE(nearest_hits(world, {}).value().empty());
    EXPECT_TRUE(occluded(world, {}).value().empty());
    EXPECT_EQ(nearest_hits(World(), rays).value()[0].shape, k_none);
}

TEST(RayQueries, GlassOccludesByTheConventions) {
    Scene scene;
    scene.materials.assign(1, Material{});
    scene.materials[0].transmission = 0.5;
    scene.add(Sphere{{0, 0, 0}, 1}, 0);
    const World world = *make_world(scene);
    const Ray ray[] = {{{0, 0, 5}, {0, 0, -1}}};
    EXPECT_EQ(occluded(world, ray).value()[0], 1);
    Conventions conventions;
    conventions.glass_shadow = GlassShadow::none;
    const World without = *with_rules(world, conventions, {});
    EXPECT_EQ(occluded(without, ray).value()[0], 0);
    EXPECT_EQ(nearest_hits(without, ray).value()[0].shape, 0u);
    Material opaque;
    EXPECT_EQ(occluded(*with_material(without, 0, opaque), ray).value()[0], 1);
}

}  // namespace
}  // namespace glint::test
