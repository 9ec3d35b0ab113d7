// SPDX-License-Identifier: Apache-2.0
// The same t and the same shape, to the bit, for all packet sizes and instruction sets.
#include "trace/hit_rule.h"

#include <gtest/gtest.h>

#include <bit>

#include "trace/worlds.h"

namespace glint::test {
namespace {

constexpr int k_packet_sizes[] = {1, 2, 3, 8, 17, 64};

void expect_same(const Hits& expected, const Hits& got, const World& world, const Rays& rays) {
    int wrong = 0;
    for (int i = 0; i < rays.size(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool same =
            std::bit_cast<std::uint64_t>(expected.t[at]) == std::bit_cast<std::uint64_t>(got.t[at]) &&
            expected.slot[at] == got.slot[at] && expected.element[at] == got.element[at];
        if (same || ++wrong > 3) continue;
        const Vec3 o = rays.origin(i), d = rays.direction(i);
        const auto name = [&](std::uint32_t slot) {
            return slot == k_none ? std::string("none")
                                  : "shape " + std::to_string(world.parts().geometry->shape_index[slot]);
        };
        ADD_FAILURE() << std::hexfloat << "ray " << i << " {" << o.x << ", " << o.y << ", " << o.z << "} -> {"
                      << d.x << ", " << d.y << ", " << d.z << "}: expected t " << expected.t[at] << " of "
                      << name(expected.slot[at]) << ", got " << got.t[at] << " of " << name(got.slot[at]);
    }
    EXPECT_EQ(wrong, 0) << "of " << rays.size() << " rays";
}

/// nearest_hit and any_hit agree with `expected` for every instruction set and packet size.
void expect_all(const World& world, const Rays& rays, const Hits& expected) {
    for (const Kernels& kernels : available_kernels()) {
        for (const int packet : k_packet_sizes) {
            SCOPED_TRACE(std::string(kernels.isa) + ", packets of " + std::to_string(packet));
            expect_same(expected, nearest_hits(kernels, world, rays, packet), world, rays);
            const auto occluded = any_hits(kernels, world, rays, packet);
            int wrong = 0;
            for (std::size_t i = 0; i < occluded.size(); ++i)
                wrong += (occluded[i] != 0) != (expected.slot[i] != k_none);
            EXPECT_EQ(wrong, 0) << "any_hit";
            if (::testing::Test::HasFailure()) return;
        }
    }
}

/// Rays of many kinds; once the first ones have hits, also rays that start at these.
Rays all_sorts(Random& random, const Scene& scene, const World& world, int count, double half) {
    Rays rays;
    while (rays.size() < count) {
        const Vec3 o = point_in_cube(random, 1.5 * half);
        switch (below(random, 6)) {
            case 0:
                rays.push(o, unit_direction(random) * log_uniform(random, 1e-3, 1e3));
                break;
            case 1:
                rays.push(o, axis_direction(random));
                break;
            case 2: {  // in the plane of two axes
                Vec3 d = unit_direction(random);
                (below(random, 2) ? d.x : d.y) = chance(random, 0.5) ? 0.0 : -0.0;
                rays.push(o, d);
                break;
            }
            case 3: {  // coherent: a bundle of 24
                const Vec3 to = point_in_cube(random, half);
                for (int i = 0; i < 24; ++i) {
                    rays.push(o, to - o + Vec3{0.01 * half * (i % 6), 0.01 * half * (i / 6), 0});  // NOLINT
                }
                break;
            }
            case 4: {  // from within a shape, or towards it from near and far, with a limit
                const auto& spheres = scene.get<Sphere>();
                if (spheres.empty()) break;
                const Sphere& s =
                    spheres[static_cast<std::size_t>(below(random, static_cast<int>(spheres.size())))];
                const Vec3 d = unit_direction(random);
                rays.push(s.center + d * (s.radius * random.uniform(0, 1)), unit_direction(random));
                rays.push(s.center, axis_direction(random));
                rays.push(s.center - d * 100.0, d, 0.001, random.uniform(90, 101));
                break;
            }
            default: {
                const BruteHit h = brute_nearest(world, o, unit_direction(random), 0, 1e30);
                if (h.slot == k_none) break;
                const Vec3 d = unit_direction(random);
                const BruteHit found = brute_nearest(world, o, d, 0, 1e30);
                if (found.slot != k_none) rays.push(o + d * found.t, unit_direction(random));
                if (found.slot != k_none) rays.push(o + d * found.t, axis_direction(random), 0.001);
            }
        }
    }
    return rays;
}

TEST(HitRule, RandomScenes) {
    Random random(11);
    for (const int count : {1, 2, 7, 16, 40, 150, 1000, 5000}) {
        for (int repeat = 0; repeat < (count < 100 ? 6 : 1); ++repeat) {
            SCOPED_TRACE(std::to_string(count) + " shapes, scene " + std::to_string(repeat));
            const Scene scene = random_scene(random, count);
            const std::optional<World> world = make_world(scene);
            ASSERT_TRUE(world);
            const Rays rays = all_sorts(random, scene, *world, 1200, 10);
            const Hits expected = brute_hits(*world, rays);
            int hit = 0;
            for (const std::uint32_t slot : expected.slot) hit += slot != k_none;
            if (count >= 16) {
                EXPECT_GT(hit, 200);
            }
            expect_all(*world, rays, expected);
            if (HasFailure()) return;
        }
    }
}

TEST(HitRule, TouchingSpheres) {
    Random random(12);
    Scene scene;
    add_flake(scene, {0, 0, 0}, 4, {0, 0, 0}, 4);
    const std::optional<World> world = make_world(scene);
    Rays rays = all_sorts(random, scene, *world, 3000, 8);
    // Through the points where the spheres touch, along the axes.
    for (const Sphere& s : scene.get<Sphere>()) {
        if (rays.size() > 5000) break;
        rays.push(s.center + Vec3{s.radius, 0, 20}, {0, -0.0, -1});
        rays.push(s.center + Vec3{s.radius, 0, 0}, {1, 0, 0});
    }
    expect_all(*world, rays, brute_hits(*world, rays));
}

TEST(HitRule, BigSphereNextToSmallOnes) {
    Random random(13);
    Scene scene;
    scene.add(Sphere{{0, -5001, 0}, 5000});
    for (int i = 0; i < 40; ++i)
        scene.add(Sphere{{random.uniform(-8, 8), random.uniform(-1, 2), random.uniform(-8, 8)}, 1});
    const std::optional<World> world = make_world(scene);
    const Rays rays = all_sorts(random, scene, *world, 4000, 10);
    expect_all(*world, rays, brute_hits(*world, rays));
}

TEST(HitRule, GridsOfAlignedShapesAndAxisParallelRays) {
    // Boxes have common planes with rays in them, where slab tests divide 0 by 0.
    Scene scene;
    for (int x = 0; x < 9; ++x) {
        for (int y = 0; y < 9; ++y) {
            if ((x + y) % 3 == 0) {
                scene.add(Cylinder{{2.0 * x, 2.0 * y, 0}, {2.0 * x, 2.0 * y, 1}, 1, (x + y) % 2 == 0});
            } else {
                scene.add(Sphere{{2.0 * x, 2.0 * y, 0}, 1});
            }
        }
    }
    const std::optional<World> world = make_world(scene);
    Rays rays;
    for (const double zero : {0.0, -0.0}) {
        for (int i = -2; i <= 19; ++i) {
            for (const double z : {-1.0, 0.0, 0.5, 1.0}) {
                rays.push({double(i), -3, z}, {zero, 1, -zero});
                rays.push({double(i), 21, z}, {zero, -1, zero});
                rays.push({-3, double(i), z}, {1, zero, zero});
                rays.push({double(i), double(i), z}, {zero, -zero, 1});
                rays.push({21, double(i), z}, {-1, -zero, zero});
            }
        }
    }
    expect_all(*world, rays, brute_hits(*world, rays));
}

TEST(HitRule, EqualBoxes) {
    // The first of 100,000 coincident spheres is hit. There are a few other spheres among them.
    constexpr std::uint32_t count = 100000;
    Scene scene;
    for (std::uint32_t i = 0; i < count; ++i) scene.add(Sphere{{1, 2, 3}, 1});
    const std::optional<World> world = make_world(scene, 2);
    ASSERT_TRUE(world);
    Random random(14);
    Rays rays;
    for (int i = 0; i < 6; ++i) rays.push(Vec3{1, 2, 3} + unit_direction(random) * 5, unit_direction(random));
    for (int i = 0; i < 6; ++i) {
        const Vec3 o = point_in_cube(random, 9);
        rays.push(o, Vec3{1, 2, 3} - o);
    }
    const Hits expected = brute_hits(*world, rays);
    for (int i = 6; i < 12; ++i) {
        ASSERT_NE(expected.slot[static_cast<std::size_t>(i)], k_none);
        EXPECT_EQ(world->parts().geometry->shape_index[expected.slot[static_cast<std::size_t>(i)]], 0u);
    }
    expect_all(*world, rays, expected);
}

TEST(HitRule, TiesGoToTheFirstInTheScene) {
    // The same surface as a sphere, a transformed sphere and a plane that touches it, in every order.
    for (int order = 0; order < 6; ++order) {
        Scene scene;
        scene.transforms.push_back(Affine{});
        const int first = order % 3, second = (first + 1 + order / 3) % 3;
        const auto add = [&](int which) {
            if (which == 0) scene.add(Sphere{{0, 0, -5}, 1});
            if (which == 1) scene.add(Sphere{{0, 0, -5}, 1}, k_none, 0);
            if (which == 2) scene.add(Plane{{0, 0, -4}, {0, 0, 1}});
        };
        add(first), add(second), add(3 - first - second);
        const std::optional<World> world = make_world(scene);
        Rays rays;
        for (int i = 0; i < 9; ++i) rays.push({0, 0, 0}, {0, 0, -1});
        for (const Kernels& kernels : available_kernels()) {
            for (const int packet : k_packet_sizes) {
                const Hits hits = nearest_hits(kernels, *world, rays, packet);
                for (int i = 0; i < 9; ++i) {
                    const auto at = static_cast<std::size_t>(i);
                    ASSERT_NE(hits.slot[at], k_none);
                    EXPECT_EQ(hits.t[at], 4);
                    EXPECT_EQ(world->parts().geometry->shape_index[hits.slot[at]], 0u)
                        << kernels.isa << " order " << order;
                }
            }
        }
    }
}

TEST(HitRule, OnTheEdgesBetweenAPolygonsTriangles) {
    // A square is two triangles: on its diagonal both are hit at the same t.
    Scene scene;
    for (int i = 0; i < 30; ++i) {
        const double x = i % 6, y = i / 6;  // NOLINT(bugprone-integer-division)
        const auto first = static_cast<std::uint32_t>(scene.polygon_vertices.size());
        for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}) {
            scene.polygon_vertices.push_back(corner + Vec3{x, y, 0.25 * i});
        }
        scene.add(Polygon{first, 4});
    }
    const std::optional<World> world = make_world(scene);
    ASSERT_EQ(world->parts().geometry->count, 60u);
    Random random(17);
    Rays rays;
    for (int i = 0; i < 2000; ++i) {
        const double x = below(random, 6), y = below(random, 5), along = below(random, 17) / 16.0;
        const bool up = chance(random, 0.5);
        rays.push({x + along, y + (chance(random, 0.5) ? along : 1 - along), up ? -3.0 : 20.0},
                  {0, 0, up ? 1.0 : -1.0});
    }
    expect_all(*world, rays, brute_hits(*world, rays));
}

TEST(HitRule, DirectionsOfAnyLength) {
    Random random(18);
    const Scene scene = random_scene(random, 200);
    const std::optional<World> world = make_world(scene);
    Rays rays;
    for (int i = 0; i < 6000; ++i) {
        rays.push(point_in_cube(random, 12), unit_direction(random) * log_uniform(random, 1e-28, 1e28));
    }
    const Hits expected = brute_hits(*world, rays);
    int hit = 0;
    for (const std::uint32_t slot : expected.slot) hit += slot != k_none;
    EXPECT_GT(hit, 1000);
    expect_all(*world, rays, expected);
}

TEST(HitRule, EmptyScene) {
    const std::optional<World> world = make_world(Scene{});
    ASSERT_TRUE(world);
    Rays rays;
    for (int i = 0; i < 70; ++i) rays.push({0, 0, 0}, {0, 0, 1}, 0, 100.0 + i);
    const Hits expected = brute_hits(*world, rays);
    EXPECT_EQ(expected.t[3], 103);
    expect_all(*world, rays, expected);
}

TEST(HitRule, ExponentiallySpacedSpheres) {
    // The builder splits them off one by one, which makes the hierarchy as deep as possible.
    Scene scene;
    for (int i = 0; i < 1600; ++i) {
        const double at = std::pow(10.0, -6 + 17.0 * i / 1600);
        scene.add(Sphere{{at, 0, 0}, at * 0.003});
    }
    const std::optional<World> world = make_world(scene);
    Random random(15);
    Rays rays;
    for (int i = 0; i < 400; ++i) {
        const double at = log_uniform(random, 1e-6, 1e11);
        rays.push({at, at, at}, Vec3{0, -at, -at} + unit_direction(random) * (at * 0.003));
        rays.push({at, 0, 0}, {chance(random, 0.5) ? 1.0 : -1.0, 0, -0.0});
    }
    expect_all(*world, rays, brute_hits(*world, rays));
}

TEST(HitRule, InvalidRaysMissAndDoNotAffectOthers) {
    Random random(16);
    const Scene scene = random_scene(random, 300);
    const std::optional<World> world = make_world(scene);
    Rays good = all_sorts(random, scene, *world, 400, 10);
    const int parallel_from = good.size();
    const Vec3 along = unit_direction(random);
    for (int i = 0; i < 100; ++i) good.push(point_in_cube(random, 12), along);
    const Hits expected = brute_hits(*world, good);
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    const Vec3 bad_values[] = {{nan, nan, nan},  {nan, 0, 1},           {1, nan, 0},
                               {infinity, 0, 0}, {0, -infinity, 1},     {infinity, infinity, nan},
                               {1e39, 0, 0},     {1e300, 1e300, 1e300}, {0, 0, 0}};
    Rays mixed;
    std::vector<int> where;
    std::vector<bool> must_miss;
    for (int i = 0; i < good.size(); ++i) {
        if (chance(random, 0.3)) {
            const Vec3 v = bad_values[below(random, 9)];
            const bool parallel = i >= parallel_from, as_direction = !parallel && chance(random, 0.5);
            mixed.push(as_direction ? Vec3{0, 0, 0} : v, as_direction ? v
                                                         : parallel   ? along
                                                                      : unit_direction(random));
            where.push_back(-1);
        }
        mixed.push(good.origin(i), good.direction(i), good.t_min(i), good.t_max(i));
        where.push_back(i);
    }
    for (const Kernels& kernels : available_kernels()) {
        for (const int packet : k_packet_sizes) {
            SCOPED_TRACE(std::string(kernels.isa) + ", packets of " + std::to_string(packet));
            const Hits all = nearest_hits(kernels, *world, mixed, packet);
            const auto occluded = any_hits(kernels, *world, mixed, packet);
            Hits got;
            int wrong = 0;
            for (std::size_t i = 0; i < where.size(); ++i) {
                EXPECT_FALSE(std::isnan(all.t[i])) << "ray " << i;
                if (where[i] < 0) continue;
                got.t.push_back(all.t[i]);
                got.slot.push_back(all.slot[i]);
                got.element.push_back(all.element[i]);
                const std::uint32_t slot = expected.slot[static_cast<std::size_t>(where[i])];
                wrong += (occluded[i] != 0) != (slot != k_none);
            }
            EXPECT_EQ(wrong, 0) << "any_hit";
            expect_same(expected, got, *world, good);
            if (HasFailure()) return;
        }
    }
}

}  // namespace
}  // namespace glint::test
