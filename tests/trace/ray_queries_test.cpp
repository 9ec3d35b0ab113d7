// SPDX-License-Identifier: Apache-2.0
// nearest_hits() and occluded(): what the kernels say, in the scene's own terms.
#include "trace/hit_rule.h"
#include "trace/worlds.h"

namespace glint::test {
namespace {

TEST(RayQueries, AreTheHitRule) {
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
        const RayHits found = nearest_hits(world, rays, threads);
        const Occlusions any = occluded(world, rays, threads);
        EXPECT_EQ(found.error, "");
        EXPECT_EQ(any.error, "");
        ASSERT_EQ(found.hits.size(), rays.size());
        ASSERT_EQ(any.occluded.size(), rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::uint32_t slot = expected.slot[i];
            EXPECT_EQ(found.hits[i].t, expected.t[i]);
            EXPECT_EQ(found.hits[i].shape,
                      slot == k_none ? k_none : world.parts().geometry->shape_index[slot]);
            EXPECT_EQ(any.occluded[i], slot == k_none ? 0 : 1);
        }
    }
}

TEST(RayQueries, GiveTheShapesOwnNormal) {
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
    const RayHits found = nearest_hits(world, rays);
    EXPECT_EQ(found.hits[0].t, 1.5);
    EXPECT_EQ(found.hits[0].normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(found.hits[1].normal, (Vec3{0, 0, 1})) << "from inside";
    EXPECT_EQ(found.hits[2].shape, 1u);
    EXPECT_EQ(found.hits[2].normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(found.hits[3].shape, k_none);
    EXPECT_EQ(found.hits[3].t, 7);
    EXPECT_EQ(found.hits[4].shape, k_none);
    EXPECT_TRUE(nearest_hits(world, {}).hits.empty());
    EXPECT_TRUE(occluded(world, {}).occluded.empty());
    EXPECT_EQ(nearest_hits(World(), rays).hits[0].shape, k_none);
}

TEST(RayQueries, GlassOccludesByTheConventions) {
    Scene scene;
    scene.materials.assign(1, Material{});
    scene.materials[0].transmission = 0.5;
    scene.add(Sphere{{0, 0, 0}, 1}, 0);
    const World world = *make_world(scene);
    const Ray ray[] = {{{0, 0, 5}, {0, 0, -1}}};
    EXPECT_EQ(occluded(world, ray).occluded[0], 1);
    Conventions conventions;
    conventions.glass_shadow = GlassShadow::none;
    const World without = *with_rules(world, conventions, {}).world;
    EXPECT_EQ(occluded(without, ray).occluded[0], 0);
    EXPECT_EQ(nearest_hits(without, ray).hits[0].shape, 0u);
    Material opaque;
    EXPECT_EQ(occluded(*with_material(without, 0, opaque).world, ray).occluded[0], 1);
}

}  // namespace
}  // namespace glint::test
